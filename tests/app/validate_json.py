#!/usr/bin/env python3
"""usage: validate_json.py SCHEMA FILE -- status 0: valid; 1: not; 77: python3-jsonschema is missing"""
import json
import sys

try:
    import jsonschema
except ModuleNotFoundError:
    sys.exit(77)

with open(sys.argv[1]) as schema_file, open(sys.argv[2]) as file:
    schema = json.load(schema_file)
    validator = jsonschema.validators.validator_for(schema)(schema)  # the draft that it names
    errors = list(validator.iter_errors(json.load(file)))
for error in errors:
    print(f"{error.json_path}: {error.message}", file=sys.stderr)
sys.exit(1 if errors else 0)
