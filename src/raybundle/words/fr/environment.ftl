environment-native_unknown = RAYBUNDLE_NATIVE = { $chosen } est inconnu.

environment-native_missing = Les noyaux compilés manquent.
