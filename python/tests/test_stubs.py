"""The stubs say what the compiled module has, no more and no less."""

from __future__ import annotations

import ast
from pathlib import Path

import signorini
from signorini import _core

#: What Python gives to every class, or what stands in the stubs as a base.
COMMON = {"to_dict"}


def stub() -> ast.Module:
    """Both stub files, read."""
    folder = Path(signorini.__file__).parent
    return ast.parse("\n".join(
        (folder / name).read_text(encoding="utf-8")
        for name in ("_core.pyi", "_answers.pyi")))


def names_in(tree: ast.Module, cls: ast.ClassDef) -> set[str]:
    """Public names of a class and its bases."""
    names = set()
    for node in cls.body:
        if isinstance(node, ast.FunctionDef):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            assert isinstance(node.target, ast.Name)
            names.add(node.target.id)
    bases = {base.id for base in cls.bases if isinstance(base, ast.Name)}
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and node.name in bases:
            names |= names_in(tree, node)
    return {name for name in names if not name.startswith("_")}


def test_classes_have_the_attributes_of_the_stubs() -> None:
    tree = stub()
    classes = {node.name: node for node in tree.body
               if isinstance(node, ast.ClassDef)}
    for name, cls in vars(_core).items():
        if not isinstance(cls, type) or issubclass(cls, Exception):
            continue
        assert name in classes, f"{name} has no stub"
        has = {attribute for attribute in vars(cls)
               if not attribute.startswith("_")}
        says = names_in(tree, classes[name])
        assert has - COMMON == says - COMMON, name


def test_functions_are_those_of_the_stubs() -> None:
    says = {node.name for node in stub().body
            if isinstance(node, ast.FunctionDef)}
    has = {name for name, value in vars(_core).items()
           if callable(value) and not isinstance(value, type)}
    assert has == says


def test_every_attribute_has_a_docstring() -> None:
    for cls in vars(_core).values():
        if isinstance(cls, type) and cls is not _core.AtlasFile:
            for name, value in vars(cls).items():
                if not name.startswith("_"):
                    assert value.__doc__, f"{cls.__name__}.{name}"


def test_editors_complete_what_motions_are_asked_for() -> None:
    """No key that a motion has is of the type Any."""
    loose = {f"{cls.name}.{node.target.id}"
             for cls in stub().body if isinstance(cls, ast.ClassDef)
             for node in cls.body if isinstance(node, ast.AnnAssign)
             if isinstance(node.target, ast.Name)
             and ast.unparse(node.annotation) == "Any"}
    loose |= {f"{cls.name}.{node.name}"
              for cls in stub().body if isinstance(cls, ast.ClassDef)
              for node in cls.body if isinstance(node, ast.FunctionDef)
              if node.returns and ast.unparse(node.returns) == "Any"
              and node.name != "frame"}
    assert not loose


def test_all_that_the_package_says_it_has_is_there() -> None:
    import signorini
    assert [name for name in signorini.__all__
            if name != "plot" and not hasattr(signorini, name)] == []


def test_keywords_that_calls_about_bars_take_are_those_of_the_stubs() -> None:
    folder = Path(signorini.__file__).parent
    tree = ast.parse((folder / "_keywords.pyi").read_text(encoding="utf-8"))
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    one = names_in(tree, classes["Demands"])
    several = names_in(tree, classes["DemandsOfBars"])
    assert "strain_limit" in one
    # Beside these the same is asked of both.
    assert one - several == {"bar", "cells", "formulation", "second_stop", "segments", "tip_floor"}
    assert several - one == {"gravity"}
    found = signorini.find(3, 11, scene="clamp 4 gap=2e-3 4 clamp", strain_limit=1e-3)
    assert found.status == "none"
