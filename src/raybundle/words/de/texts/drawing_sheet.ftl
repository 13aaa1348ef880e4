drawing_sheet-axes = Ursprung { $at_point ->
        [yes] in { $origin }
        *[no] in der Mitte der Punkte
    }, rechts { $right ->
        [points] von { $first } nach { $second }
        [block] längs X und Y des Bildverbands
        *[level] waagerecht
    }

drawing_sheet-beside = Punkte außerhalb der Ebene, im Bild versetzt (RMS über die Aufnahmen):

drawing_sheet-beside_more = { $n } { $n ->
        [one] weiterer Punkt
        *[other] weitere Punkte
    }.

drawing_sheet-beside_point = { $name }: { NUM($off_mm, digits: 2) } mm.

drawing_sheet-field = { $name ->
        [title] Titel
        [object] Objekt
        [place] Ort
        [reference] Nachweise
        [client] Auftraggeber
        [operator] Bearbeiter
        [date] Datum
        [instruments] Geräte
        [rights] Rechte
        [coordinates] Koordinaten
        [scale] Maßstab
        [paper] Blattgröße
        *[sheet] Blatt
    }

drawing_sheet-kind = { $kind ->
        [control] Passpunkt
        [check] Kontrollpunkt
        [point] gemessener Punkt
        [tie] Verknüpfungspunkt
        [distance] Strecke
        [plumb_line] Lotrechte
        [level] Waagerechte
        [straight_line] gerade Linie
        *[plane] Ebene
    }

drawing_sheet-lean = Ihre Punkte neigen sich { $back ->
        [yes] nach hinten
        *[no] nach vorn
    }, um { NUM($angle_deg, digits: 2) }{ $known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } Grad.

drawing_sheet-lengths = Längen an ihren Linien gelten im Raum.

drawing_sheet-map = { $system }{ $named ->
        [yes] {" "}({ $name })
        *[no] {""}
    }{ $level ->
        [yes] , ebener Boden in der Höhe { NUM($height, decimals: 2) }
        *[no] {""}
    }

drawing_sheet-moved = Punkte außerhalb der Ebene sind im Bild um das { NUM($slope, decimals: 2) }-fache ihres Abstands verschoben (RMS).

drawing_sheet-other_sheet = Blatt { $number }

drawing_sheet-paper = { $name } { $landscape ->
        [yes] Querformat
        *[no] Hochformat
    }

drawing_sheet-pixel = Pixel { $pictures ->
        [one] des Bildes
        *[other] der Bilder
    }: { LIST($sizes_mm, most: 5) } mm{ $n ->
        [0] {""}
        [one] , aus { $n } Aufnahme
        *[other] , aus { $n } Aufnahmen
    }.

drawing_sheet-plane = { $kind ->
        [vertical] Lotrechte
        [horizontal] Waagerechte
        *[other] Ausgleichende
    } Ebene durch { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    }{ $known ->
        [yes] , Abstand { NUM($rms, digits: 2) } { $unit } (RMS)
        *[no] {""}
    }.

drawing_sheet-plane_axes = der Ebene: X nach rechts, Y nach oben{ $more ->
        [yes] ;
        *[no] {""}
    }

drawing_sheet-precision = Standardabweichung { $n ->
        [one] eines benannten Punktes
        *[other] von { $n } benannten Punkten
    } (RMS): { $map ->
        [yes] E
        *[no] X
    } { NUM($x_mm, digits: 2) } mm, { $map ->
        [yes] N
        *[no] Y
    } { NUM($y_mm, digits: 2) } mm, { $map ->
        [yes] Höhe
        *[no] quer zur Ebene
    } { NUM($z_mm, digits: 2) } mm.

drawing_sheet-vertical = Lotrichtung:

drawing_sheet-sheets = Gezeichnet: 1 : { $scale } auf { $paper }, { $n } { $n ->
        [one] Blatt
        *[other] Blätter ({ $columns } x { $rows })
    }.

drawing_sheet-content = Inhalt: Bilder { $pictures }, Punkte { $points }, Linien { $lines }.

drawing_sheet-other_block = Das Bild gehört zum Block { $block }, die Punkte zu { $other }.

drawing_sheet-metres_assumed = Die Einheit des Bildes ist unbekannt; Meter werden angenommen.

drawing_sheet-shortened = Im Schriftfeld gekürzt: { LIST($names, most: 12) }.

drawing_sheet-letters = Zeichen, die ein Blatt nicht darstellen kann, sind als Fragezeichen gedruckt: { LIST($letters, most: 10) }.

drawing_sheet-true_orthophoto = Echtes Orthofoto: { PERCENT($share) } % auf gemessenen Höhen, { PERCENT($filled) } % ergänzt, { PERCENT($white) } % von keiner Aufnahme gesehen.

drawing_sheet-place_sigma = Standardabweichung des Ortes eines gemessenen Pixels: { NUM($sigma_mm, digits: 2) } mm (Median).
