#!/usr/bin/env python3
"""Whether a page of docs/guides shows the program it is about, and what that prints.

    guide.py PAGE SOURCE PROGRAM
"""

import re
import subprocess
import sys


def block(page, language):
    found = re.search(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    return found.group(1) if found else ""


def main():
    page_name, source, program = sys.argv[1:]
    with open(page_name, encoding="utf-8") as file:
        page = file.read()
    with open(source, encoding="utf-8") as file:
        if block(page, "cpp") != file.read():
            sys.exit(f"{page_name} does not show {source} as it is")
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    if block(page, "text") != printed:
        sys.exit(f"{page_name} does not show what {program} prints:\n{printed}")


main()
