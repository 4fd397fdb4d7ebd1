(** The checkers in OCaml, and the paper's operators to compare rows with. Lists, pairs, options and booleans
    become OCaml's own; numbers stay as they are defined here, so nothing about arithmetic is taken on trust. *)

From Coq Require Import Extraction ExtrOcamlBasic.
From Signorini Require Import Checker Bars Operators Sums Network.

Extraction Language OCaml.
Extraction "proved.ml" summed check leastEnergy bar stepsOf periodQ openedQ conditionsQ
  startRows stepOf checkNetwork.
