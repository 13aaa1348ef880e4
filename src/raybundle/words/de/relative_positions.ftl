relative_positions = Die Positionen stimmen untereinander besser überein, als ihre Standardabweichungen angeben.
    .why = { $control ->
     [yes] Der gemeinsame Versatz der Positionen folgt aus den Passpunkten.
     *[no] Die angegebenen Standardabweichungen gelten für ihren gemeinsamen Versatz, den keine Verbesserung zeigt.
    }
    .do = { $control ->
     [yes] { "" }
     *[no] Passpunkte angeben, um diesen Versatz zu bestimmen.
    }

relative_positions-direction = { $direction ->
     [plan] In der Lage
     *[height] In der Höhe
    }: { NUM($sigma_m, digits: 2) } m, angegeben oder angenommen { NUM($stated_m, digits: 2) } m
