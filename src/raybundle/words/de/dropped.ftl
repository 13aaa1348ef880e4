dropped = { PERCENT($share) } % der Bildpunkte wurden vor der Ausgleichung verworfen.
    .why = Merkmale { $features }, zugeordnet { $matched }, hinzugefügt { $added }. Verworfen: { $contradict_orientation } durch die genäherte Orientierung, { $not_measured } durch Kleinste-Quadrate-Zuordnung, { $contradict_others } durch andere Strahlen. Übernommen { $adjusted }, in der Ausgleichung { $given }.
