# $first = "a"
# $second = "b"
# $n = 2
# $least = 3
frames-too_few_points = { $first } and { $second }: { $n } common points; a comparison needs { $least }.
    .do = Measure more points that both have in common.

# $first = "a"
# $second = "b"
frames-covariance_singular = { $first } and { $second }: the joint covariance matrix is singular.
    .why = Points that are held without error cannot be compared.
    .do = Give the held points standard deviations, then adjust again.
