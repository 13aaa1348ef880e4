# $point = "12"
# $apart_mm = 0.401
points_fit-apart = Point { $point }: { $apart_mm } mm apart.

# $first = "12"
# $second = "17"
points_fit-names_exchanged = With the names { $first } and { $second } exchanged, both fit.

# $names = ["3", "8"]
points_fit-instead = Excluding { $names } instead explains the differences equally well.
