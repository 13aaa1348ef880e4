point-number_invalid = { $number } ist keine brauchbare Punktnummer.
    .do = Die Datei neu exportieren.

point-sigma_without_coordinate = Punkt { $point } hat { $sigma }, aber kein { $coordinate }.
    .do = Die Koordinate angeben oder { $sigma } leer lassen.

point-tie_with_sigma = Verknüpfungspunkt { $point } hat eine Standardabweichung.
    .do = Seine Rolle in control ändern oder die Standardabweichung leer lassen.

point-control_without_sigma = Passpunkt { $point } hat keine Koordinate mit Standardabweichung.
    .do = Eine angeben (0 = fest) oder seine Rolle in tie ändern.

point-check_without_coordinate = Kontrollpunkt { $point } hat keine Koordinate.
    .do = Eine angeben oder seine Rolle in tie ändern.

point-sigma_out_of_range = Punkt { $point }, { $axis }: { $sigma } ist keine Standardabweichung.
    .do = 0 (festgehalten), eine Zahl über 0 oder NaN (genäherte Koordinate) angeben.

point-no_coordinate = Passpunkt { $point } hat eine Standardabweichung ({ $sigma }), aber keine Koordinate { $axis }.
    .do = Die Koordinate angeben oder NaN als Standardabweichung.

point-not_in_result = Nicht im Ergebnis oder ohne Koordinaten: { $names }.
    .do = Punkte des Ergebnisses angeben.

point-window_too_large = Das Fenster { NUM($window, digits: 6) } des Punktes { $point } ist größer als die Ausdehnung aller Punkte, { NUM($extent, digits: 6) }.
    .do = Es in der Einheit der Koordinaten angeben.
