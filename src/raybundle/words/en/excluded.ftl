excluded-undetermined = The remaining points do not determine the orientation of the image.
    .do = Measure more points in the image.

# $n = 4
excluded-few_points = The { $n } remaining points do not determine the orientation of the image.
    .do = Measure more points in the image.

# $photographs = 3
excluded-part = A separate part of { $photographs } photographs is not determined.

excluded-few_points_at_date = Too few of its points have a second ray at its date.
