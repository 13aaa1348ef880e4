result_readme-title = { $name }: Ergebnisordner, geschrieben von raybundle { $version }.

result_readme-file = { $entry ->
        [report_html] Bericht für den Browser
        [report_pdf] Bericht für den Druck
        [network_html] Netz in drei Dimensionen für den Browser
        [map_csv] Standpunkte und Punkte im Koordinatensystem der Passpunkte
        [map_control_csv] Pass- und Kontrollpunkte in diesem System mit ausgeglichen minus gegeben
        [coordinate_list_csv] gemessene Koordinaten für die Tabellenkalkulation
        [nominal_csv] Abweichungen von Sollkoordinaten
        [lengths_csv] gemessene gegen bekannte Längen
        [calibration_toml] kalibrierte Kameras für { OPTION("calibration") } späterer Läufe
        [record_toml] Aufnahmebogen: Auftraggeber, Objekt, Ort, Bearbeiter, Rechte
        [result_json] Statistik, Kameras, Korrelationen und Warnungen für Programme
        [block] ausgeglichener Block mit allen Stellen für weitere Ausgleichungen
        [images] äußere Orientierungen: Projektionszentren und Drehungen
        [points] Objektpunkte
        [observations] Bildpunkte mit Residuen und Tests
        [control] Passpunkte: gegeben, mit Residuen und Tests
        [check] Kontrollpunkte: gegeben, und ausgeglichen minus gegeben
        [distances] Maßstabsstrecken
        [stations] beobachtete Projektionszentren
        [attitudes] beobachtete Drehwinkel
       [displacements_csv] Verschiebungen zwischen den Daten in den Achsen X, Y, Z, mit Standardabweichungen, Tests und Urteil
        [velocities_csv] Geschwindigkeiten und Beschleunigungen bewegter Punkte und Flächen, ab drei Daten [m, Jahre], mit Standardabweichungen und Tests
        [surface_strain_csv] Dehnungen der Oberfläche zwischen den Daten, von Gruppen und Nachbarpunkten, mit Standardabweichungen und Tests
        [epochs_json] Daten der Aufnahmen, bewegte Punkte und Flächen, Grenze, Änderungen früherer Ergebnisse
       *[other] Beobachtungen dieser Art mit Residuen und Tests
    }

result_readme-rules = Tabellen: UTF-8, Kommas, Dezimalpunkte; eine leere Zelle ist keine Zahl.
    .why = Spalten ohne Einheit im Namen sind { $unit ->
        [none] in einer willkürlichen Einheit: nichts bestimmt den Maßstab
       *[other] in { $unit }
    }.

result_readme-column = { $content ->
        [coordinates] Koordinaten im Objektraum
        [angles] Drehung des Bildes, R = R(omega) R(phi) R(kappa)
        [image_point] Bildpunkt: x nach rechts, y nach unten, von der linken oberen Ecke des Formats
        [sigma] Standardabweichungen a posteriori
        [sigma_given] Standardabweichungen der Beobachtungen a priori
        [p_wrong] Wahrscheinlichkeit, dass der Standpunkt einer Aufnahme falsch ist
        [rays] Anzahl der Bildbeobachtungen in der Ausgleichung
        [window] Größe des Fensters eines Verknüpfungspunkts im Objektraum
        [roughness] Standardabweichung längs des Strahls aus dem Relief im Fenster; in sX, sY, sZ enthalten
        [correlation] Korrelationen der Koordinaten
        [difference] ausgeglichen minus gegeben
        [adjusted] ausgeglichener Wert
        [residual] Residuum: ausgeglichen minus beobachtet
        [redundancy] Redundanzanteil, 0 (nicht kontrolliert) bis 1 (voll kontrolliert)
        [normalised] normiertes Residuum: v durch seine Standardabweichung a priori
        [test] dasselbe a posteriori
        [detectable] kleinster grober Fehler, der gefunden würde (1 von 1000 falsch, 80 % gefunden)
       *[rejected] Grund der Zurückweisung; leer: in der Ausgleichung
    }
