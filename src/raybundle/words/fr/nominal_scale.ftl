nominal_scale = Les points nominaux et mesurés diffèrent en échelle de { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] un facteur de { NUM($factor, digits: 6) }
     }.
