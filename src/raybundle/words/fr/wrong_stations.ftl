wrong_stations = { $n } { $n ->
        [one] station est fausse
       *[other] stations sont fausses
    } avec une probabilité de plus de { PERCENT($limit) } % : { LIST($ids, most: 4) }.
