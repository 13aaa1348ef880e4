images-no_base = Die Strahlen zu { $parallel } von { $points } Objektpunkten sind auf { $limit_deg }° parallel: { $images }.
    .why = Diese Bilder haben keine Basis, sind dieselbe Aufnahme oder haben falsche Orientierungen oder Punktnummern.
    .do = Von verschiedenen Standpunkten aufnehmen oder die gegebenen Werte prüfen.
