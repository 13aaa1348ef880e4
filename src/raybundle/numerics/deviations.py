"""Standard deviations and correlations of three quantities that were observed together, and of what follows from them.

The three are coordinates of a position, components of a baseline, or angles of an attitude.  Correlation coefficients
stand in the order of `PAIRS`: of the first with the second, the first with the third, the second with the third.
"""

from __future__ import annotations

import numpy as np

from raybundle.numerics.arrays import Array, Mask

PAIRS = ((0, 1), (0, 2), (1, 2))
COUPLED = 1e-12
"""Entries of a rotation below which two axes do not touch: products of rotations leave such remains of zeros."""
CORRELATED = 1e-9
"""Correlation of two coordinates above which standard deviations alone do not say what is known of them."""
SMALLEST = 1e-10
"""Least eigenvalue of a correlation matrix: files with ten digits hold no more, and a free network's is 0."""


def correlation_matrices(coefficients: Array | None, count: int) -> Array:
    """(count, 3, 3) of coefficients (count, 3); NaN and None count as 0."""
    found = np.tile(np.eye(3), (count, 1, 1))
    if coefficients is not None:
        for n, (i, j) in enumerate(PAIRS):
            found[:, i, j] = found[:, j, i] = np.nan_to_num(coefficients[:, n])
    return found


def stated(coefficients: Array | None, count: int) -> Mask:
    """(count,) rows of coefficients (count, 3) of which one is not 0."""
    return np.zeros(count, bool) if coefficients is None else (np.nan_to_num(coefficients) != 0).any(axis=1)


def least_eigenvalues(coefficients: Array | None, count: int) -> Array:
    """(count,) least eigenvalues of the correlation matrices: above 0 where the coefficients are possible together."""
    return np.linalg.eigvalsh(correlation_matrices(coefficients, count))[:, 0]


def deviations_of(covariance: Array) -> tuple[Array, Array]:
    """Standard deviations (k, 3) and correlation coefficients (k, 3) of covariances (k, 3, 3)."""
    sigma = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
    return sigma, np.stack([covariance[:, i, j] / (sigma[:, i] * sigma[:, j]) for i, j in PAIRS], axis=1)


def unfounded(sigma: Array, coefficients: Array) -> Mask:
    """(k, 3) coefficients other than 0 with a quantity that was not observed: sigma (k, 3) is not greater than 0."""
    observed = np.nan_to_num(sigma) > 0
    lacking = np.stack([~(observed[:, i] & observed[:, j]) for i, j in PAIRS], axis=1)
    return np.asarray(lacking & (np.nan_to_num(coefficients) != 0), bool)


def deviations_after(by: Array, sigma: Array) -> Array:
    """Standard deviations (k, 3) of x' = by x, those of the uncorrelated x being sigma (k, 3), NaN where not known.

    by  (3, 3), or (k, 3, 3) of each row
    NaN where x' needs what is not known.  Correlations of x' are lost: `kept_after` shows where there are none.
    """
    new = np.sqrt(np.einsum("...ij,...j->...i", without_remains(by) ** 2, np.nan_to_num(sigma) ** 2))
    return np.where(known_after(by, ~np.isnan(sigma)), new, np.nan)


def correlated_after(by: Array, sigma: Array, coefficients: Array | None) -> tuple[Array, Array | None]:
    """Standard deviations (k, 3) and correlation coefficients (k, 3) of x' = by x, those of x being as given.

    by            (3, 3), or (k, 3, 3) of each row
    sigma         (k, 3), NaN where not known
    coefficients  (k, 3) of x; None: x is uncorrelated
    returns       coefficients None where x was uncorrelated and x' is
    """
    A, deviations = without_remains(by), np.abs(np.nan_to_num(sigma))
    C = deviations[:, :, None] * correlation_matrices(coefficients, len(sigma)) * deviations[:, None, :]
    C = A @ C @ np.swapaxes(A, -1, -2)
    new = np.sqrt(np.maximum(np.diagonal(C, axis1=1, axis2=2), 0.0))
    known = known_after(by, ~np.isnan(sigma))
    safe = np.where(known & (new > 0), new, np.inf)
    found = np.stack([C[:, i, j] / (safe[:, i] * safe[:, j]) for i, j in PAIRS], axis=1)
    given = stated(coefficients, len(sigma))[:, None]
    found = np.where(given | (np.abs(found) > CORRELATED), found, 0.0)
    spread = np.where(given, np.where(known, new, np.nan), deviations_after(by, sigma))
    return spread, None if coefficients is None and not found.any() else found


def kept_after(by: Array, sigma: Array, *, alone: bool = False) -> Mask:
    """(k,) whether standard deviations of x' = by x say all that is known of the uncorrelated x, sigma as above.

    alone  sigma shows by its NaN alone what is known; x' may be correlated
    """
    known, A = ~np.isnan(sigma), without_remains(by)
    lost = known & ((A != 0) & ~known_after(by, known)[..., :, None]).any(axis=-2)
    if alone:
        return ~lost.any(axis=-1)
    C = (A * np.nan_to_num(sigma)[..., None, :] ** 2) @ np.swapaxes(A, -1, -2)
    size = np.sqrt(np.diagonal(C, axis1=-2, axis2=-1))
    off = np.abs(C) > CORRELATED * size[..., :, None] * size[..., None, :]
    return ~lost.any(axis=-1) & ~(off & ~np.eye(3, dtype=bool)).any(axis=(-1, -2))


def drawn(rng: np.random.Generator, sigma: Array, coefficients: Array | None = None) -> Array:
    """Normally distributed errors of standard deviations sigma, NaN where those are.

    sigma         (k,) or (k, 3)
    coefficients  (k, 3) correlations of the three of a row; None: independent
    """
    errors = rng.normal(0, 1, sigma.shape)
    rows = stated(coefficients, len(sigma))
    if coefficients is not None and rows.any():
        root = np.linalg.cholesky(correlation_matrices(coefficients[rows], int(rows.sum())))
        errors[rows] = (root @ errors[rows][:, :, None])[:, :, 0]
    return errors * sigma


def without_remains(by: Array) -> Array:
    """A rotation, or derivatives of angles, with zeros in place of what rounding has left of them."""
    return np.where(np.abs(by) > COUPLED, by, 0.0)


def known_after(by: Array, known: Mask) -> Mask:
    """(k, 3) coordinates after that need none before that is not known (k, 3)."""
    return np.asarray(~((np.abs(by) > COUPLED) & ~known[..., None, :]).any(axis=-1))
