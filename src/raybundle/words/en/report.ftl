# $language = "xx"
# $known = ["en", "de", "fr"]
report-unknown_language = There are no reports in the language { $language }.
    .do = Give one of { LIST($known, most: 20) }.

# $name = "scale_bars"
# $known = ["points", "images"]
report-no_table = The result has no table { $name }.
    .do = Give one of { LIST($known, most: 60) }.
