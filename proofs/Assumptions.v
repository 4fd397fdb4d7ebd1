(** What the theorems rest on, all together, printed; tools/proofs compares it with assumptions.txt. *)

From Signorini Require Import Sound Network OneContact Verdict Operators Joined Agreed PaperNetwork.

Definition theorems :=
  (check_correct, checkLeast_correct, checkNetwork_correct, checkNetworkLeast_correct,
   one_contact, verdict_correct, least_energy, least_energy_attained,
   rational_rows, rational_one_contact, rational_verdict, same_rows, no_others, verdict_of_chain, check_of_paper, least_of_paper,
   network_of_paper, checkNetwork_of_paper).

Goal True.
  idtac "check_correct, checkLeast_correct, checkNetwork_correct, checkNetworkLeast_correct,".
  idtac "one_contact, verdict_correct, least_energy, least_energy_attained,".
  idtac "rational_rows, rational_one_contact, rational_verdict, same_rows, no_others,".
  idtac "verdict_of_chain, check_of_paper, least_of_paper, network_of_paper, checkNetwork_of_paper".
Abort.
Print Assumptions theorems.
