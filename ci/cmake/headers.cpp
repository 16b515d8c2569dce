// Holds precompiled headers that many targets share.
