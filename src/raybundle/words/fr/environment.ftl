environment-native_unknown = RAYBUNDLE_NATIVE = { $chosen } est inconnu.
