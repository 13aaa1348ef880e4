product-gone = Un produit de l'étape { $stage } est endommagé ou manque.
