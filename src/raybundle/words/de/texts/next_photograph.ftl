next_photograph-brings = { $goal ->
        [worst] Größtes σ
        [mean] Mittleres σ
        [points] Größtes σ der gewählten Punkte
        *[calibration] Größte Unsicherheit der Abbildung
    }: { $after_known ->
        [yes] { NUM($after, digits: 2) } { $after_unit ->
            [units] Einheiten
            *[other] { $after_unit }
        }
        *[no] nicht bestimmbar
    }{ $alike ->
        [yes] , { PERCENT($less, digits: 1) } % weniger
        *[no] {" "}statt { $before_known ->
            [yes] { NUM($before, digits: 2) } { $before_unit ->
                [units] Einheiten
                *[other] { $before_unit }
            }
            *[no] nicht bestimmbar
        }
    }.

next_photograph-brings_parameters = Kleinere Standardabweichungen: { $parameters }.

next_photograph-brings_point = Punkt { $point }: { $after_known ->
        [yes] { NUM($after, digits: 2) } { $after_unit ->
            [units] Einheiten
            *[other] { $after_unit }
        }
        *[no] nicht bestimmbar
    }{ $alike ->
        [yes] , { PERCENT($less, digits: 1) } % weniger
        *[no] {" "}statt { $before_known ->
            [yes] { NUM($before, digits: 2) } { $before_unit ->
                [units] Einheiten
                *[other] { $before_unit }
            }
            *[no] nicht bestimmbar
        }
    }.

next_photograph-camera = Kamera { $camera }:

next_photograph-goal = { $goal ->
        [worst] größtes σ
        [mean] mittleres σ
        [points] größtes σ der gewählten Punkte
        *[calibration] größte Unsicherheit der Abbildung
    }

next_photograph-hold = { $against ->
        [yes] { $upside_down ->
            [yes] Die Kamera gegen Aufnahme { $name } auf den Kopf gestellt halten.
            *[no] Die Kamera wie bei Aufnahme { $name } halten.
        }
        *[no] { $upside_down ->
            [yes] Die Kamera auf den Kopf gestellt halten.
            *[no] Die Kamera aufrecht halten.
        }
    }

next_photograph-look = { $sideways ->
        [none] {""}
        [right] { $sideways_deg } Grad nach rechts
        *[left] { $sideways_deg } Grad nach links
    }{ $sideways ->
        [none] {""}
        *[other] { $upwards ->
            [none] {""}
            *[other] {" "}und{" "}
        }
    }{ $upwards ->
        [none] {""}
        [up] { $upwards_deg } Grad nach oben
        *[down] { $upwards_deg } Grad nach unten
    } zielen, von der Blickrichtung der Aufnahme { $name } aus.

next_photograph-middle = { $near ->
        [yes] Nahe der Bildmitte
        *[no] In der Bildmitte
    }: { $named ->
        [yes] Punkt { $point }
        *[no] die Stelle bei { $x_px }; { $y_px } px in Aufnahme { $image }
    }.

next_photograph-place = Von Aufnahme { $name } aus { $known ->
        [yes] { NUM($one, digits: 2) } { $unit }
        *[no] { NUM($one, digits: 2) }
    } { $first ->
        [right] nach rechts
        [left] nach links
        [upper_edge] zu seinem oberen Rand hin
        [lower_edge] zu seinem unteren Rand hin
        [higher] höher
        [lower] tiefer
        [nearer] näher heran
        *[farther] weiter zurück
    }{ $second ->
        [none] {""}
        *[other] , { $known ->
            [yes] { NUM($two, digits: 2) } { $unit }
            *[no] { NUM($two, digits: 2) }
        } { $second ->
            [right] nach rechts
            [left] nach links
            [upper_edge] zu seinem oberen Rand hin
            [lower_edge] zu seinem unteren Rand hin
            [higher] höher
            [lower] tiefer
            [nearer] näher heran
            *[farther] weiter zurück
        }
    }{ $third ->
        [none] {""}
        *[other] , { $known ->
            [yes] { NUM($three, digits: 2) } { $unit }
            *[no] { NUM($three, digits: 2) }
        } { $third ->
            [right] nach rechts
            [left] nach links
            [upper_edge] zu seinem oberen Rand hin
            [lower_edge] zu seinem unteren Rand hin
            [higher] höher
            [lower] tiefer
            [nearer] näher heran
            *[farther] weiter zurück
        }
    }{ $known ->
        [yes] {""}
        *[no] {" "}(1: Abstand von dort zum Objekt)
    }.

next_photograph-predicted = Standardabweichungen mit den Vorschlägen; Bildpunkte so genau wie bisher.

next_photograph-proposal = { $name }:

next_photograph-roll = Die Kamera um { $angle_deg } Grad { $clockwise ->
        [yes] im Uhrzeigersinn
        *[no] gegen den Uhrzeigersinn
    } kanten, { $against ->
        [yes] gegenüber Aufnahme { $name }
        *[no] die { $clockwise ->
            [yes] rechte
            *[no] linke
        } Seite nach unten
    }.

next_photograph-same_place = Auf den Standpunkt von Aufnahme { $name } stellen.

next_photograph-shows = Sichtbar sein müssen { $points }{ $more ->
        [0] {""}
        [one] {" "}und { $more } weiterer Punkt
        *[other] {" "}und { $more } weitere Punkte
    }.

next_photograph-shows_tie_points = Sie zeigt { $n } { $n ->
        [one] Verknüpfungspunkt
        *[other] Verknüpfungspunkte
    }.

next_photograph-about = { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    } vorgeschlagen, mit vorhergesagten Bildpunkten
