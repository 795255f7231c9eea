// Stored chunk of a plan: the blob of a row of <name>_leg, up to 16 consecutive legs of one object.
//
//   ChunkWriter writer(plan, 42);                        // of object 42
//   for (std::size_t i = 0; i < writer.chunks(); ++i) rows.write(first + i, writer.blob(i, first + i));
//
//   StoredChunk chunk;
//   if (const char* fault = open_chunk(layout, blob, 8, chunk)) …
//   if (const char* fault = append_legs(chunk, legs)) …  // or append_to_plan(chunk, plan)
//
//     byte 0   1      2       3      4..5   6..7   8..15    only the first chunk of a plan
//   +--------+------+-------+------+------+------+--------+ - - - - - - - - - - - - - - -+------+-----+----------+
//   | format | kind | flags | axes | legs | ends | object | chunks | legs of all | starts| legs | end | checksum |
//   |  1     |      |       |      |      |      |        |  u32   |    u32      | f64   |      |     |  u32     |
//   +--------+------+-------+------+------+------+--------+ - - - - - - - - - - - - - - -+------+-----+----------+
//
// `kind` is PlanKind. Knots: a leg is t, x…, and bit i of `ends` says that leg i ends a part; then the last knot of the
// part follows, t, x…, as it does behind the last leg. Other kinds: a leg is t, x…, v…, and a… of accelerated legs. If
// each leg ends when the next one starts, the last until follows; else, by a flag, t is followed by until in each leg.
// `starts` are the t of all chunks. Velocities of knots are computed when read (plan_legs.h). Little-endian; the
// checksum is that of nodes (node_format.h), with the number of the chunk. Plans read back bit for bit.
//
// Cost: reading some 10 ns per leg.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/plan/chunks.h"
#include "motion/plan/plan.h"
#include "shape/row_layout.h"

namespace foresee {

/// Chunks are numbered from 1 to this, because a record stores the number in a double.
constexpr std::int64_t largest_chunk_number = std::int64_t{1} << 53;

/// A blob whose checksum, header and size are right. Valid as long as the blob.
struct StoredChunk {
  PlanKind kind = PlanKind::knots;
  bool is_first = false;
  bool has_untils = false;  ///< a flag: an until in each leg
  std::size_t axes = 0, legs = 0;
  std::uint16_t ends = 0;
  std::int64_t object = 0;
  std::size_t plan_chunks = 0, plan_legs = 0;  ///< of the first chunk
  const std::byte* starts = nullptr;           ///< of the first chunk: plan_chunks doubles, unaligned
  const std::byte* numbers = nullptr;          ///< of the legs

  double start(std::size_t chunk) const;
  /// The t of the first leg.
  double t() const;
};

/// Encodes the chunks of one plan. Throws Error if no double holds the velocity of a leg.
/// Requires: check_plan() accepts the plan, which outlives this.
class ChunkWriter {
 public:
  ChunkWriter(const Plan& plan, std::int64_t object);

  std::size_t chunks() const { return ranges_.size(); }
  const std::vector<Leg>& all_legs() const { return legs_; }
  std::span<const Leg> legs(std::size_t chunk) const {
    return std::span(legs_).subspan(ranges_[chunk].first, ranges_[chunk].count);
  }
  std::vector<std::byte> blob(std::size_t chunk, std::int64_t number) const;

 private:
  std::size_t part_of(std::size_t leg) const;
  StoredChunk header(std::size_t chunk) const;
  void put_legs(const StoredChunk& header, std::size_t first, std::byte* at) const;

  const Plan& plan_;
  std::int64_t object_;
  std::vector<Leg> legs_;
  std::vector<ChunkRange> ranges_;
};

/// Opens the blob of row `number` in a table of this layout. Returns what is wrong with it; null: nothing.
const char* open_chunk(const Layout& layout, std::span<const std::byte> blob, std::int64_t number,
                       StoredChunk& chunk);

/// What is wrong with the numbers of the legs, but for the velocities between knots; null: nothing.
const char* check_legs(const StoredChunk& chunk);

/// The legs that exist at some of these times, and perhaps others, as a chunk. Cost: a binary search, if all legs have
/// as many numbers. Requires: check_legs() accepts the chunk.
StoredChunk legs_during(const StoredChunk& chunk, const LegTimes& times);

/// Appends the legs that exist at some of these times. Returns what is wrong with the numbers of all legs, but of the
/// velocities between knots those of these legs; null: nothing. Requires: FloatEnvironment.
const char* append_legs(const StoredChunk& chunk, std::vector<Leg>& legs, const LegTimes& times = {});

/// Appends the legs to those before them, as the plan was written: the first chunk to an empty plan. Returns what is
/// wrong with the numbers, or with their order; null: nothing. Requires: FloatEnvironment.
const char* append_to_plan(const StoredChunk& chunk, Plan& plan);

/// The bytes of a chunk as one of another object. Requires: open_chunk() accepts it.
std::vector<std::byte> chunk_of_object(std::span<const std::byte> blob, std::int64_t number,
                                       std::int64_t object);

}  // namespace foresee
