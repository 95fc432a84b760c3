// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGzipDecoder_h
#define SeismicHorizonsGzipDecoder_h

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Whether a stream goes on with what gzip begins its files with. The stream stays where it is.
bool BeginsAsGzip(std::istream& stream);

/// Decodes what gzip wrote (RFC 1952), piece by piece in a fixed amount of memory, and checks it: several files of gzip
/// one after the other are one, and zeros may follow the last, as tapes leave them.
class GzipDecoder
{
public:
  explicit GzipDecoder(std::unique_ptr<std::istream> compressed);
  ~GzipDecoder();
  GzipDecoder(const GzipDecoder&) = delete;
  GzipDecoder& operator=(const GzipDecoder&) = delete;

  /// Gives the next bytes: fewer than `count` only before the end or an error, and none at the end. Throws InputError
  /// with the number of the compressed byte, counted from 0, when there are none because something is wrong.
  std::size_t Read(char* bytes, std::size_t count);

  /// Goes back to the first byte.
  void Rewind();

  /// Which part of the compressed bytes was used, 0 to 1.
  double PartRead() const;

private:
  void Advance();
  bool Fill();
  void FindMember();
  void SetProblem(const std::string& text);
  std::int64_t Position() const;

  struct Inflation;
  const std::unique_ptr<std::istream> Compressed;
  const double CompressedSize; // bytes
  const std::unique_ptr<Inflation> State;
  std::vector<char> Input; // the compressed bytes at hand
  std::int64_t BytesTaken = 0; // from the stream
  bool IsInMember = true; // or before the next one, or the end
  bool IsInPadding = false;
  bool IsAtEnd = false;
  std::string Problem; // empty while there is none
};
}

#endif
