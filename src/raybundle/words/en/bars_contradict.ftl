# $names = ["B1", "B2"]
# $p = 1e-06
# $uncertain = 0.004
# $sigma_mm = 1.8
# $ids = ["B1", "B2"]
bars_contradict = Scale bars contradict each other ({ P($p) }): { $names }.
    .why = Lengths are uncertain by { PERCENT($uncertain) } % until this is settled; the bars take part with sigma up to { NUM($sigma_mm, digits: 2) } mm.
    .do = Check certificates, units and end points of these bars, or add a bar.

# $names = ["B1", "B2"]
# $p = 1e-06
# $uncertain = 0.004
# $sigma_mm = 1.8
# $ids = ["B1", "B2"]
# $first = "B1"
# $second = "B2"
bars_contradict-exchanged = Scale bars contradict each other ({ P($p) }); with the lengths of { $first } and { $second } exchanged they agree.
    .why = Lengths are uncertain by { PERCENT($uncertain) } % until this is settled.
    .do = Check whether the certificates of { $first } and { $second } were exchanged.

# $names = ["B1"]
# $p = 1e-06
# $uncertain = 0.004
# $sigma_mm = 1.8
# $ids = ["B1"]
bars_contradict-one = Scale bar { $names } contradicts the other bars ({ P($p) }), which agree.
    .why = It takes part with sigma { NUM($sigma_mm, digits: 2) } mm, so it does not distort the result.
    .do = Check its certificate, unit and end points.

# $bar = "B1"
# $given_mm = 1000.02
# $others = ""
# $measured_mm = 1003.1
# $apart_mm = 3.1
# $sigma_mm = 0.2
bars_contradict-bar = { $bar }: given { NUM($given_mm, digits: 8) } mm, by the other bars { NUM($measured_mm, digits: 8) } mm (difference { $apart_mm } mm, sigma { NUM($sigma_mm, digits: 2) } mm).
