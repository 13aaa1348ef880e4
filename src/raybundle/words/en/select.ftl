# $name = "images"
# $n = 3
# $count = 5
select-mask = A mask of { $n } values was given for { $count } { $name }.
    .do = Give one value for each, or ids.

# $name = "images"
select-twice = The selection of { $name } contains one of them twice.
    .do = Give each once.
