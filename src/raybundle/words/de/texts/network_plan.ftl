network_plan-title = Plan: { $name }

network_plan-promise = Standardabweichungen sind die des Plans, mit { NUM($sigma_px) } px der Bildpunkte.

network_plan-frame = { $control ->
        [0] Sie gelten relativ zu allen Punkten zusammen{ $bars ->
            [0] .
            *[other] , mit dem Maßstab der Maßstabsstrecken und dessen Fehler.
        }
        *[other] Sie gelten im System von { $control } { $control ->
            [one] Passpunkt
            *[other] Passpunkten
        }{ $bars ->
            [0] .
            [one] {" "}und { $bars } Maßstabsstrecke.
            *[other] {" "}und { $bars } Maßstabsstrecken.
        }
    }{ $control ->
        [0] { $bars ->
            [0] {" "}Eine Maßstabsstrecke oder Passpunkte geben den Maßstab und bringen ihren eigenen Fehler ein.
            *[other] {""}
        }
        *[other] {""}
    }

network_plan-grey = Graue Teile des Objekts sind in weniger als zwei Aufnahmen.

network_plan-known = { $control ->
        [yes] Passpunkt{ $bar ->
            [yes] , Maßstabsstrecke
            *[no] {""}
        }
        *[no] Maßstabsstrecke
    }

network_plan-points_unseen = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } { $side ->
        [top] oben
        [below] unten
        [front] vorn (nach -Y)
        [back] hinten (nach +Y)
        [right] rechts (nach +X)
        *[left] links (nach -X)
    } { $n ->
        [one] wäre
        *[other] wären
    } ohne sie in weniger als zwei Aufnahmen zu finden.

network_plan-undetermined = Ohne sie ist das Netz nicht bestimmt.

network_plan-larger = { $what ->
        [worst] Größtes Sigma
        [mean] Mittleres Sigma
        [calibration] Unsicherheit der Kalibrierung
        [reliability] Schwächste Kontrolle eines Bildpunkts
        [top] Oben: Sigma
        [below] Unten: Sigma
        [front] Vorn (nach -Y): Sigma
        [back] Hinten (nach +Y): Sigma
        [right] Rechts (nach +X): Sigma
        [left] Links (nach -X): Sigma
        *[parameter] { $what }
    } ohne sie { $size ->
        [hardly] kaum bestimmt
        [times] { NUM($ratio, decimals: 0) }-mal so groß
        *[per_cent] { NUM($per_cent, decimals: 0) } % größer
    }.

network_plan-about = geplant: { $photographs } Aufnahmen von { $points } Punkten, Bildpunkte von { $sigma_px } px
