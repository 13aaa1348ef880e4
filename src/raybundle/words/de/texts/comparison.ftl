comparison-result = { $name }: { $known ->
        [yes] sigma0 { NUM($sigma0, digits: 6) }
        *[no] sigma0 unbekannt
    }, Redundanz { $redundancy }.

