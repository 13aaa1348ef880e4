# $name = "sceaux-castle"
# $source = "https://example.org"
dataset-origin = { $name }: { $source }

# $licence = "CC0"
# $cite = "none"
dataset-licence = licence: { $licence }{ $cite ->
        [none] {""}
        *[other] ; cite: { $cite }
    }

# $n = 11
# $there = 0
dataset-fetched = Fetched and checked: { $n } { $n ->
        [one] file
        *[other] files
    }{ $there ->
        [0] {""}
        *[other] ; { $there } existed already
    }.
