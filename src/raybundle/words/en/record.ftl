# $known = ["title", "client"]
record-unknown_entry = The record has no such entry.
    .do = Use one of { LIST($known, most: 30) }.

record-not_a_text = An entry of the record is a text.
    .do = Write the value in quotes.

# $name = "client"
# $n = 20000
# $most = 2000
record-too_long = Entry { $name } of the record has { $n } characters; at most { $most } are possible.
    .do = Shorten it.
