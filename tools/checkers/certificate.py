"""What an answer of `find` proves."""
from .energies import check_energies
from .floor import check_floor, check_least
from .network_claim import check_scene
from .network_cuts import check_scene_forced
from .paper import check_farkas
from .reading import NoProof, require_keys, shown
from .scene import ASKED, BESIDES, DERIVED, Scene, unsaid
from .segments import check_joints
from .sums import check_sums

ENERGIES = ("objective", "energy_ratio", "energy_ratio_range")
# What an answer without a motion does not say.
EMPTY = ("contact", "canonical_schedule", "energy", "energy_section", "physical", "admissible", "residuals")
KIND = ("kind", "verified", "rows")
LISTS = ("equalities", "inequalities")
FLOOR = ("periodicity", "places", "pushes")


def check_paper(scene, certificate):
    """Over the rows of (30)-(32)."""
    where = scene.reach()
    if len(where) > 1:
        raise NoProof("rows: those of the paper know one stop")
    return check_farkas(scene.cells, scene.phases, where["right"], certificate)


# By status, kind and rows: who checks, keys that have to be there, and that may be.
PROOFS = {
    ("none", "farkas", "paper"): (
        check_paper, ("gap",), ("size", "periodicity", "pressure", "penetration", "landing")),
    ("none", "farkas", "lumped"): (check_sums, LISTS, ("strain_limit", "tip_floor")),
    ("none", "farkas", "joints"): (check_joints, LISTS, ("tip_floor",)),
    ("none", "energy-range", "lumped"): (check_energies, (*LISTS, "energy_ratio"), ("strain_limit",)),
    ("found", "energy-range", "lumped"): (check_energies, LISTS, ()),
    ("none", "energy-floor", "network"): (
        check_floor, (*FLOOR, "energy_ratio"), ("tip_floor", "strain_limit", "strains")),
    ("found", "energy-floor", "network"): (
        check_least, (*FLOOR, "energy_ratio", "state"), ("tip_floor", "strain_limit", "strains")),
}


def claim_of(answer, proof):
    """What is said to be so, before the why."""
    if proof[1] == "farkas":
        return "no periodic motion of"
    return "energies of periodic motions of"


def check(answer):
    """What an answer proves, in a sentence. NoProof if it proves nothing."""
    if isinstance(answer, dict) and "scene" in answer:
        return check_scene_forced(answer) if "cycles" in answer else check_scene(answer)
    require_keys(answer, "answer", ASKED, (*ENERGIES, *BESIDES, *DERIVED, *EMPTY))
    certificate = answer["certificate"]
    if not isinstance(certificate, dict):
        raise NoProof(f"certificate: {shown(certificate)} is no object")
    proof = answer["status"], certificate.get("kind"), certificate.get("rows")
    if not all(isinstance(word, str) for word in proof) or proof not in PROOFS:
        raise NoProof(f"status {shown(proof[0])}, kind {shown(proof[1])} over rows {shown(proof[2])}: not known to "
                      "this checker")
    checks, needed, allowed = PROOFS[proof]
    require_keys(certificate, "certificate", (*KIND, *needed), allowed)
    if not isinstance(certificate["verified"], bool):  # there; it is verified here
        raise NoProof("verified: allowed true or false")
    for key in EMPTY + (ENERGIES[1:] if proof[1] == "farkas" else ()):
        if answer.get(key) is not None:
            raise NoProof(f"{key}: {shown(answer[key])} is not proved here")
    scene = Scene(answer)
    scene.require_derived(answer)
    if proof[2] not in ("joints", "network") and not scene.is_uniform():
        raise NoProof("segments: rows of one bar are not those of several segments")
    why = checks(scene, certificate if proof[1] == "farkas" else answer)
    more = ENERGIES[:1] if proof[1] == "farkas" else ()
    return f"{claim_of(answer, proof)} {scene.text()}, free and undamped: {why}{unsaid(answer, more)}"
