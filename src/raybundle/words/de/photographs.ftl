photographs-targets = Zielmarken der Aufnahme { $photograph }:
