package-sympy_missing = Deriving an own sensor model needs the package SymPy.
    .do = Run: pip install 'raybundle[models]'
