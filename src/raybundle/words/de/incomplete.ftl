incomplete = Nur { $oriented } von { $photographs } Aufnahmen sind orientiert (Grenze { PERCENT($limit) } %).
    .do = Aufnahmen mit 60 % Überdeckung oder mehr machen oder die Aufnahmen jedes Objekts getrennt orientieren.
