#!/bin/bash
# page_in_chromium.sh EXAMPLE: opens the page that the program EXAMPLE writes in headless Chromium, as
# a file and without network, in several views, and compares what the page says it drew with what
# the bar of page_bar.hpp must show. Status 77: there is no Chromium.
set -u
chromium=$(command -v chromium || command -v chromium-browser) || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" > "$work/page.html" && "$1" rest > "$work/rest.html" || exit 1
page=page.html
failures=0

# browse FRAGMENT ARGUMENT..
browse() {
  timeout 100 "$chromium" --headless --no-sandbox --disable-quic --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$(mktemp -d -p "$work")" --use-angle=swiftshader --enable-unsafe-swiftshader \
    --enable-logging=stderr --virtual-time-budget=5000 --window-size=1280,800 "${@:2}" "file://$work/$page$1" 2> "$work/log"
}

# expect FRAGMENT TEXT..: the document, after it was drawn, has every TEXT.
expect() {
  browse "$1" --dump-dom > "$work/dom.html"
  for text in 'data-state="ready"' "${@:2}"; do
    grep -qF -- "$text" "$work/dom.html" && continue
    failures=$((failures + 1))
    echo "$page$1 has no $text; it has: $(grep -o '<html[^>]*>' "$work/dom.html")"
    tail -5 "$work/log"
  done
  grep -o 'data-error="[^"]*"' "$work/dom.html" && failures=$((failures + 1))
  grep 'CONSOLE' "$work/log" && failures=$((failures + 1))
}

# The page opens on the last state: cut through, both sides of 32 facets.
expect "" 'data-cells="1536"' 'data-triangles="640"' 'data-skin="576"' 'data-opened="64"' \
  'data-position="3"' '>iteration limit<' '>vertex 500<' '>vertex 500: a copy of 8<' \
  '<div class="caption" id="caption-after">Cut through<'
# Half cut: 16 facets open; the shut one is inside the body.
expect "#state=1" 'data-triangles="608"' 'data-opened="32"' 'data-shut="0"' '>Half cut<'
# Sliced in the middle plane: half the skin, one side of the cut, and the shut facet among the rest.
expect "#state=1&slice=x,0.5&colour=material" 'data-triangles="320"' 'data-skin="288"' \
  'data-opened="16"' 'data-shut="1"' 'data-inside="15"' \
  '>right &lt;/script&gt;</p>' 'x = 280 mm'
# At rest nothing is open; what is no view is left alone.
expect "#state=0&colour=none&slice=x,2&camera=a,b" 'data-triangles="576"' 'data-opened="0"'

# With nothing but a body at rest there is no timeline, finding, plot or choice of displacement.
page=rest.html
expect "#colour=displacement&state=1" 'data-triangles="576"' 'data-opened="0"' '<div id="timeline" hidden' \
  'id="findings-section" hidden' 'id="plot-section" hidden' 'id="scale-row" hidden' \
  'data-value="plain" aria-pressed="true"'
page=page.html

# A picture of a body has far more to compress than an empty canvas with its background.
browse "#ui=0" --hide-scrollbars --screenshot="$work/page.png" > /dev/null
browse "#ui=0&camera=0,0,0.0001&findings=0" --hide-scrollbars --screenshot="$work/empty.png" > /dev/null
if [ "$(stat -c %s "$work/page.png")" -lt $((2 * $(stat -c %s "$work/empty.png"))) ]; then
  failures=$((failures + 1))
  echo "the canvas looks empty: $(stat -c '%n %s' "$work"/*.png)"
fi

[ "$failures" -eq 0 ] && echo "page.html is drawn as it should be"
exit $((failures > 0))
