epochs_scale = Die Epochen { $first } und { $second } unterscheiden sich im Maßstab um { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] einen Faktor von { NUM($factor, digits: 6) }
     }.
    .why = Das sind { $sigmas } Standardabweichungen ihrer Maßstäbe; der Maßstab ist nun frei, eine gleichmäßige Dehnung wird nicht erkannt.
    .do = Die Maßstabsstrecken beider Epochen prüfen: { $bars }.
