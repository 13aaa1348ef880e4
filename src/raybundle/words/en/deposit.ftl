# $n = 3
# $names = ["operator", "rights", "archive"]
deposit-entries_missing = The record lacks what archives ask for: { LIST($names, most: 6) }.
    .do = Give them by `raybundle record`, and write the package again.

# $n = 2
# $names = ["IMG_3.jpg", "IMG_4.jpg"]
deposit-photographs_missing = { $n } { $n ->
        [one] photograph is
       *[other] photographs are
    } not there: { LIST($names, most: 3) }.
    .do = Bring the photographs back to their folder, and write the package again.
