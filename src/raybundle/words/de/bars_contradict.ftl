bars_contradict = Maßstabsstrecken widersprechen einander ({ P($p) }): { $names }.
    .why = Bis zur Klärung sind Längen um { PERCENT($uncertain) } % unsicher; die Strecken gehen mit Sigma bis { NUM($sigma_mm, digits: 2) } mm in die Ausgleichung ein.
    .do = Kalibrierscheine, Einheiten und Endpunkte dieser Strecken prüfen oder eine Strecke ergänzen.

bars_contradict-exchanged = Maßstabsstrecken widersprechen einander ({ P($p) }); mit vertauschten Längen von { $first } und { $second } stimmen sie.
    .why = Bis zur Klärung sind Längen um { PERCENT($uncertain) } % unsicher.
    .do = Prüfen, ob die Kalibrierscheine von { $first } und { $second } vertauscht sind.

bars_contradict-one = Maßstabsstrecke { $names } widerspricht den übrigen ({ P($p) }), die übereinstimmen.
    .why = Diese Strecke geht mit Sigma { NUM($sigma_mm, digits: 2) } mm in die Ausgleichung ein und verformt das Ergebnis nicht.
    .do = Kalibrierschein, Einheit und Endpunkte dieser Strecke prüfen.

bars_contradict-bar = { $bar }: angegeben { NUM($given_mm, digits: 8) } mm, nach den übrigen { NUM($measured_mm, digits: 8) } mm (Differenz { $apart_mm } mm, Sigma { NUM($sigma_mm, digits: 2) } mm).
