# New and PrintSelf of every VTK class get standard texts, and protected members are removed.
/^  static .* New();$/i\  /// Creates an instance.
/^  void PrintSelf(/i\  /// Prints its state.
/^protected:$/,/^};$/{/^};$/!d}
