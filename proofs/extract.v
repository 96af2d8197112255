From Coq Require Import Extraction ExtrOcamlBasic.
From Cleave Require half_facets certify_exec.
Extraction "verified.ml" certify_exec.certify_exec half_facets.unglue_exec.
