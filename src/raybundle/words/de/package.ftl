package-sympy_missing = Ein eigenes Sensormodell herzuleiten braucht das Paket SymPy.
    .do = Ausführen: pip install 'raybundle[models]'
