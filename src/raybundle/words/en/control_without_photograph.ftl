# $n = 12
# $table = "control.csv"
# $names = ["IMG_9.jpg"]
control_without_photograph = { $n } { $n ->
     [one] measurement
     *[other] measurements
    } of { $table } { $n ->
     [one] is
     *[other] are
    } in photographs that are missing: { LIST($names, most: 5) }.
    .do = Add these photographs, or correct their names.
