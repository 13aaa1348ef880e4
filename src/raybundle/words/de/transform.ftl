transform-wrong_shape = Feld { $name } einer Transformation: Form ({ $shape }) oder nicht endliche Werte.
    .do = Endliche Zahlen der Form ({ $needed }) angeben.
