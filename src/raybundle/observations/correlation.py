"""Correlations between the quantities of one row of a table: read and checked in one place for every kind."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.numerics.deviations import correlation_matrices, stated
from raybundle.observations.kind import Joint, Rows
from raybundle.observations.table import SIGMA, Table


def correlated(table: Table, rows: Rows) -> Rows:
    """Rows with the correlations that the table states within each of its own; where it states none, as they are.

    rows    of components 0, 1, 2 of rows of the table
    raises  InputError for coefficients that cannot be, with file, row and column
    """
    beside = table.correlations_of(SIGMA)
    coefficients = getattr(table, beside) if beside else None
    there = stated(coefficients, len(table))
    if not there.any():
        return rows
    table.check()
    matrices = correlation_matrices(coefficients, len(table))
    order = np.argsort(rows.item, kind="stable")
    item, start = np.unique(rows.item[order], return_index=True)
    joint = list[Joint]()
    for k, mine in zip(item.tolist(), np.split(order, start[1:]), strict=True):
        own = rows.component[mine]
        R = matrices[k][np.ix_(own, own)]
        if there[k] and (np.eye(len(own)) != R).any():
            joint.append(Joint(mine.astype(np.int32), R))
    return replace(rows, joint=(*rows.joint, *joint))
