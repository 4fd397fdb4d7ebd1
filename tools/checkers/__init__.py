"""Checkers of what signorini says: plain Python, standard library, nothing shared with what finds.

docs/certificates.md says what each number of a certificate means. Modules, each after those it uses:

    reading        JSON, integers, untrusted fractions and multipliers; NoProof
    scene          bar, stops and schedule of an answer
    paper          the paper's rows (30)-(32), and proofs over them
    sums, lift     rows of sums of waves; such a proof over the paper's rows
    polyhedra, energies       least and most energy of one bar
    segments       rows of a bar of several segments
    enclosed, forced_rows, forced      bars that are driven, by interval arithmetic
    apart          that no curve joins two motions
    whole, quadratic, verdicts, atlas  whole ranges of schedules
    certificate    what an answer of `find` proves: chooses among the rows
    command        files, one line for each, exit statuses
"""
