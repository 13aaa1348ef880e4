datum-control = Passpunkte

datum-minimal = minimal: { $n } Koordinaten gut verteilter Objektpunkte festgehalten ({ $names })

datum-inner = freie Netzausgleichung über { $over ->
        [all] alle Objektpunkte
        [chosen] { $n } gewählte Objektpunkte
        *[good] { $n } gut bestimmte Objektpunkte
    }{ $parts ->
        [all] {""}
        *[some] {" "}für { $names }
    }
