# $photograph = "img_07.jpg"
photographs-targets = Targets of photograph { $photograph }:

# $n = 2
# $names = ["a.jpg", "b.jpg"]
photographs-not_usable = { $n } { $n ->
        [one] file is
        *[other] files are
    } not used: { $names }.
    .why = The result lacks what only they show.
    .do = See the reasons with { OPTION("verbose", "True") } or in the report.
