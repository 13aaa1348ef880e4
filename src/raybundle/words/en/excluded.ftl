excluded-undetermined = The remaining points do not determine its orientation.

# $n = 4
excluded-few_points = The { $n } remaining points do not determine its orientation.

# $photographs = 3
excluded-part = A separate part of { $photographs } photographs is not determined.
