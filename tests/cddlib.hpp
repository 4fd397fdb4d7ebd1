#pragma once
/// \file
/// cddlib, which enumerates the vertices of polyhedra in rationals: an oracle of tests.

#include <gmp.h>

#include <cstddef>
#include <memory>

#include "catch.hpp"

#define GMPRATIONAL
extern "C" {
#include <cddlib/setoper.h>
// Needs what setoper.h defines.
#include <cddlib/cdd.h>
}

/// cddlib keeps some numbers of GMP for itself when it converts a polyhedron: no leak of ours.
extern "C" [[gnu::used]] inline const char* __lsan_default_suppressions()
{
    return "leak:__gmp_default_allocate\n";
}

namespace signorini::test {

struct DeleteCdd {
    void operator()(dd_MatrixType* matrix) const { dd_FreeMatrix(matrix); }
    void operator()(dd_LPType* program) const { dd_FreeLPData(program); }
    void operator()(dd_PolyhedraType* polyhedron) const { dd_FreePolyhedra(polyhedron); }
};
using CddMatrix = std::unique_ptr<dd_MatrixType, DeleteCdd>;

/// Rows b + A x >= 0, b in column 0, all 0 as yet; of equalities the number, from 1, goes to
/// linset.
inline CddMatrix cddRows(std::size_t rows, std::size_t unknowns)
{
    // It makes its constants anew at each call and forgets the old ones.
    [[maybe_unused]] static const bool isReady = (dd_set_global_constants(), true);
    CddMatrix matrix(
        dd_CreateMatrix(static_cast<dd_rowrange>(rows), static_cast<dd_colrange>(unknowns) + 1));
    matrix->representation = dd_Inequality;
    matrix->numbtype = dd_Rational;
    return matrix;
}

/// Vertices, 1 in column 0, and directions, 0 there; those of linset are lines.
inline CddMatrix cddGenerators(const CddMatrix& rows)
{
    dd_ErrorType error = dd_NoError;
    const std::unique_ptr<dd_PolyhedraType, DeleteCdd> polyhedron(
        dd_DDMatrix2Poly(rows.get(), &error));
    REQUIRE(error == dd_NoError);
    return CddMatrix(dd_CopyGenerators(polyhedron.get()));
}

}  // namespace signorini::test
