struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_18 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_26 {
member: array<u32>,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(3)
var<storage> global_1: type_15;
@group(0) @binding(4)
var<storage, read_write> global_2: type_15;
@group(0) @binding(0)
var<storage> global_3: type_24;
@group(0) @binding(2)
var<storage> global_4: type_15;
@group(0) @binding(1)
var<storage> global_5: type_26;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: i32;
var phi_274_: vec3<f32>;
var phi_277_: vec3<f32>;
var phi_279_: u32;
var phi_281_: f32;
var phi_903_: vec3<f32>;
var phi_906_: vec3<f32>;
var phi_919_: type_27;
var phi_1100_: u32;
var phi_1103_: f32;
var phi_1238_: i32;
var phi_1251_: i32;
var phi_1265_: i32;
var phi_1581_: i32;
var phi_1594_: i32;
var phi_1608_: i32;
var phi_1101_: u32;
var phi_1104_: f32;
var phi_1813_: f32;
var phi_2043_: vec3<f32>;
var phi_2044_: vec3<f32>;
var phi_2045_: f32;
var phi_275_: vec3<f32>;
var phi_278_: vec3<f32>;
var phi_280_: u32;
var phi_282_: f32;
var phi_2109_: u32;
var phi_2115_: u32;
var phi_2177_: u32;
var phi_2183_: u32;
var phi_2245_: u32;
var phi_2251_: u32;
var phi_2313_: u32;
var phi_2319_: u32;
var phi_2381_: u32;
var phi_2387_: u32;
var phi_2449_: u32;
var phi_2455_: u32;
var phi_2592_: i32;
var phi_2605_: i32;
var phi_2619_: i32;
var phi_2819_: f32;
var local_7: vec3<f32>;
var local_8: vec3<f32>;
var local_9: vec3<f32>;
var local_10: vec3<f32>;
var local_11: vec3<f32>;
var local_12: vec3<f32>;
var local_13: f32;
var local_14: f32;
let _e81 = global;
let _e89 = arrayLength((&global_1.member));
let _e92 = global_3.member.member;
if (_e81.x < _e92.member) {
if (_e81.y < _e92.member_1) {
let _e99 = (_e92.member * _e92.member_1);
let _e101 = ((_e81.y * _e92.member) + _e81.x);
let _e113 = global_3.member.member_13.member_4;
let _e120 = global_3.member.member_19.member;
let _e127 = (_e113.member + ((f32(_e81.x) + 0.5f) * _e120.member));
let _e128 = (_e113.member_1 + ((f32((_e81.y % 16u)) + 0.5f) * _e120.member_1));
let _e129 = (_e113.member_2 + ((f32((_e81.y / 16u)) + 0.5f) * _e120.member_2));
let _e130 = (1f / 3f);
let _e131 = (_e120.member * _e130);
let _e132 = (_e120.member_1 * _e130);
let _e133 = (_e120.member_2 * _e130);
let _e138 = (((0.57735026f * 0.6203505f) * ((_e131 + _e132) + _e133)) * _e130);
phi_274_ = vec3<f32>(0f, 0f, 0f);
phi_277_ = vec3<f32>(0f, 0f, 0f);
phi_279_ = 0u;
phi_281_ = 0f;
loop {
let _e140 = phi_274_;
let _e142 = phi_277_;
let _e144 = phi_279_;
let _e146 = phi_281_;
local_7 = _e142;
local_8 = _e142;
local_9 = _e142;
local_10 = _e140;
local_11 = _e140;
local_12 = _e140;
local_13 = _e146;
let _e147 = (_e144 < 27u);
if _e147 {
let _e164 = (_e127 + ((f32(bitcast<i32>((_e144 % 3u))) - 1f) * _e131));
let _e165 = (_e128 + ((f32(bitcast<i32>(((_e144 / 3u) % 3u))) - 1f) * _e132));
let _e166 = (_e129 + ((f32(bitcast<i32>((_e144 / 9u))) - 1f) * _e133));
let _e172 = global_3.member.member_14.member.member;
let _e188 = global_3.member.member_14.member_1.member;
if ((((((_e172.member.member * _e164) + (_e172.member.member_1 * _e165)) + (_e172.member.member_2 * _e166)) + _e172.member_1) >= 0f) && (((((_e188.member.member * _e164) + (_e188.member.member_1 * _e165)) + (_e188.member.member_2 * _e166)) + _e188.member_1) >= 0f)) {
let _e206 = global_3.member.member_10.member_3;
let _e210 = (_e164 - _e206.member);
let _e211 = (_e165 - _e206.member_1);
let _e212 = (_e166 - _e206.member_2);
let _e217 = (((_e210 * _e210) + (_e211 * _e211)) + (_e212 * _e212));
let _e220 = sqrt(select(0f, _e217, (_e217 > 0f)));
let _e222 = select(1e-6f, _e220, (_e220 > 1e-6f));
let _e225 = (select(_e138, _e222, (_e222 > _e138)) / _e222);
let _e236 = global_3.member.member_10.member;
let _e237 = (_e236 == 0u);
let _e239 = select(vec3<f32>((_e206.member + (_e210 * _e225)), (_e206.member_1 + (_e211 * _e225)), (_e206.member_2 + (_e212 * _e225))), vec3<f32>(_e164, _e165, _e166), vec3(_e237));
let _e243 = global_3.member.member_10.member_2;
if _e237 {
let _e251 = global_3.member.member_10.member_1;
phi_919_ = type_27(vec3<f32>(_e251.member, _e251.member_1, _e251.member_2), vec3<f32>(_e243.member, _e243.member_1, _e243.member_2));
} else {
let _e258 = (_e239.x - _e206.member);
let _e260 = (_e239.y - _e206.member_1);
let _e262 = (_e239.z - _e206.member_2);
let _e267 = (((_e258 * _e258) + (_e260 * _e260)) + (_e262 * _e262));
let _e269 = select(1e-12f, _e267, (_e267 > 1e-12f));
let _e270 = (1f / _e269);
let _e274 = vec3<f32>((_e243.member * _e270), (_e243.member_1 * _e270), (_e243.member_2 * _e270));
if (_e236 == 2u) {
let _e279 = global_3.member.member_10.member_1;
let _e287 = (((_e279.member * _e258) + (_e279.member_1 * _e260)) + (_e279.member_2 * _e262));
let _e290 = (1f / select(1e-20f, _e287, (_e287 > 1e-20f)));
let _e295 = global_3.member.member_10.member_4.member;
let _e304 = ((((_e295.member * _e258) + (_e295.member_1 * _e260)) + (_e295.member_2 * _e262)) * _e290);
let _e309 = global_3.member.member_10.member_4.member_1;
let _e318 = ((((_e309.member * _e258) + (_e309.member_1 * _e260)) + (_e309.member_2 * _e262)) * _e290);
let _e323 = global_3.member.member_10.member_4.member_2;
let _e326 = ((_e304 * _e304) + (_e318 * _e318));
let _e335 = global_3.member.member_10.member_4.member_3;
let _e336 = ((_e323 - sqrt(select(0f, _e326, (_e326 > 0f)))) * _e335);
let _e338 = select(0f, _e336, (_e336 > 0f));
let _e340 = select(1f, _e338, (_e338 < 1f));
let _e346 = select(0f, ((_e340 * _e340) * (3f - (2f * _e340))), (_e287 > 0f));
let _e351 = global_3.member.member_10.member_4.member_5;
if ((_e351 > 0u) && (_e346 > 0f)) {
let _e355 = (0.5f / _e323);
let _e365 = global_3.member.member_10.member_4.member_6;
let _e366 = bitcast<i32>(_e365);
local_6 = bitcast<i32>(_e351);
let _e367 = local_6;
let _e369 = f32((_e367 - 1i));
let _e371 = f32((_e366 - 1i));
let _e372 = local_6;
let _e375 = (((0.5f + (_e304 * _e355)) * f32(_e372)) - 0.5f);
let _e377 = select(0f, _e375, (_e375 > 0f));
let _e379 = select(_e369, _e377, (_e377 < _e369));
let _e382 = (((0.5f - (_e318 * _e355)) * f32(_e366)) - 0.5f);
let _e384 = select(0f, _e382, (_e382 > 0f));
let _e386 = select(_e371, _e384, (_e384 < _e371));
let _e388 = select(0f, _e379, (_e379 > 0f));
let _e390 = select(_e369, _e388, (_e388 < _e369));
let _e397 = select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < -2147483600f)), 2147483647i, (_e390 > 2147483500f)), (_e390 == _e390));
let _e401 = (_e397 - select(0i, 1i, (_e390 < f32(_e397))));
let _e403 = select(0f, _e386, (_e386 > 0f));
let _e405 = select(_e371, _e403, (_e403 < _e371));
let _e412 = select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < -2147483600f)), 2147483647i, (_e405 > 2147483500f)), (_e405 == _e405));
let _e416 = (_e412 - select(0i, 1i, (_e405 < f32(_e412))));
let _e418 = (_e379 - f32(_e401));
let _e420 = (_e386 - f32(_e416));
let _e421 = (_e401 + 1i);
let _e422 = local_6;
let _e424 = select(_e401, _e421, (_e421 < _e422));
let _e425 = (_e416 + 1i);
let _e427 = select(_e416, _e425, (_e425 < _e366));
let _e432 = global_3.member.member_10.member_4.member_4;
let _e433 = bitcast<i32>(_e432);
let _e434 = local_6;
let _e438 = (_e433 + (3i * ((_e416 * _e434) + _e401)));
let _e440 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e442 = select(_e440, _e438, (_e438 < _e440));
let _e447 = global_4.member[bitcast<u32>(select(0i, _e442, (_e442 > 0i)))];
let _e448 = (_e438 + 1i);
let _e450 = select(_e440, _e448, (_e448 < _e440));
let _e455 = global_4.member[bitcast<u32>(select(0i, _e450, (_e450 > 0i)))];
let _e456 = (_e438 + 2i);
let _e458 = select(_e440, _e456, (_e456 < _e440));
let _e463 = global_4.member[bitcast<u32>(select(0i, _e458, (_e458 > 0i)))];
let _e464 = local_6;
let _e468 = (_e433 + (3i * ((_e416 * _e464) + _e424)));
let _e470 = select(_e440, _e468, (_e468 < _e440));
let _e475 = global_4.member[bitcast<u32>(select(0i, _e470, (_e470 > 0i)))];
let _e476 = (_e468 + 1i);
let _e478 = select(_e440, _e476, (_e476 < _e440));
let _e483 = global_4.member[bitcast<u32>(select(0i, _e478, (_e478 > 0i)))];
let _e484 = (_e468 + 2i);
let _e486 = select(_e440, _e484, (_e484 < _e440));
let _e491 = global_4.member[bitcast<u32>(select(0i, _e486, (_e486 > 0i)))];
let _e492 = local_6;
let _e496 = (_e433 + (3i * ((_e427 * _e492) + _e401)));
let _e498 = select(_e440, _e496, (_e496 < _e440));
let _e503 = global_4.member[bitcast<u32>(select(0i, _e498, (_e498 > 0i)))];
let _e504 = (_e496 + 1i);
let _e506 = select(_e440, _e504, (_e504 < _e440));
let _e511 = global_4.member[bitcast<u32>(select(0i, _e506, (_e506 > 0i)))];
let _e512 = (_e496 + 2i);
let _e514 = select(_e440, _e512, (_e512 < _e440));
let _e519 = global_4.member[bitcast<u32>(select(0i, _e514, (_e514 > 0i)))];
let _e520 = local_6;
let _e524 = (_e433 + (3i * ((_e427 * _e520) + _e424)));
let _e526 = select(_e440, _e524, (_e524 < _e440));
let _e531 = global_4.member[bitcast<u32>(select(0i, _e526, (_e526 > 0i)))];
let _e532 = (_e524 + 1i);
let _e534 = select(_e440, _e532, (_e532 < _e440));
let _e539 = global_4.member[bitcast<u32>(select(0i, _e534, (_e534 > 0i)))];
let _e540 = (_e524 + 2i);
let _e542 = select(_e440, _e540, (_e540 < _e440));
let _e547 = global_4.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e554 = (_e447 + ((_e475 - _e447) * _e418));
let _e555 = (_e455 + ((_e483 - _e455) * _e418));
let _e556 = (_e463 + ((_e491 - _e463) * _e418));
phi_903_ = vec3<f32>(((_e554 + (((_e503 + ((_e531 - _e503) * _e418)) - _e554) * _e420)) * _e346), ((_e555 + (((_e511 + ((_e539 - _e511) * _e418)) - _e555) * _e420)) * _e346), ((_e556 + (((_e519 + ((_e547 - _e519) * _e418)) - _e556) * _e420)) * _e346));
} else {
phi_903_ = vec3(_e346);
}
let _e581 = phi_903_;
phi_906_ = (_e274 * _e581);
} else {
phi_906_ = _e274;
}
let _e584 = phi_906_;
let _e588 = (1f / sqrt(select(0f, _e269, (_e269 > 0f))));
phi_919_ = type_27(vec3<f32>((_e258 * _e588), (_e260 * _e588), (_e262 * _e588)), _e584);
}
let _e595 = phi_919_;
let _e597 = (_e206.member - _e164);
let _e598 = (_e206.member_1 - _e165);
let _e599 = (_e206.member_2 - _e166);
let _e604 = (((_e597 * _e597) + (_e598 * _e598)) + (_e599 * _e599));
let _e608 = select(sqrt(select(0f, _e604, (_e604 > 0f))), 1e30f, _e237);
let _e610 = -(_e595.member.x);
let _e612 = -(_e595.member.y);
let _e614 = -(_e595.member.z);
let _e622 = (1f / select(_e610, select(1e-12f, -1e-12f, (_e610 < 0f)), (bitcast<f32>((bitcast<u32>(_e610) & 2147483647u)) < 1e-12f)));
let _e630 = (1f / select(_e612, select(1e-12f, -1e-12f, (_e612 < 0f)), (bitcast<f32>((bitcast<u32>(_e612) & 2147483647u)) < 1e-12f)));
let _e638 = (1f / select(_e614, select(1e-12f, -1e-12f, (_e614 < 0f)), (bitcast<f32>((bitcast<u32>(_e614) & 2147483647u)) < 1e-12f)));
let _e642 = global_3.member.member_13.member_5;
let _e647 = ((_e113.member - _e164) * _e622);
let _e649 = ((_e642.member - _e164) * _e622);
let _e651 = ((_e113.member_1 - _e165) * _e630);
let _e653 = ((_e642.member_1 - _e165) * _e630);
let _e655 = ((_e113.member_2 - _e166) * _e638);
let _e657 = ((_e642.member_2 - _e166) * _e638);
let _e659 = select(_e649, _e647, (_e647 < _e649));
let _e661 = select(_e653, _e651, (_e651 < _e653));
let _e663 = select(_e661, _e659, (_e659 > _e661));
let _e665 = select(_e657, _e655, (_e655 < _e657));
let _e667 = select(_e665, _e663, (_e663 > _e665));
let _e669 = select(_e649, _e647, (_e647 > _e649));
let _e671 = select(_e653, _e651, (_e651 > _e653));
let _e673 = select(_e671, _e669, (_e669 < _e671));
let _e675 = select(_e657, _e655, (_e655 > _e657));
let _e677 = select(_e675, _e673, (_e673 < _e675));
let _e679 = select(0f, _e667, (_e667 > 0f));
let _e681 = select(_e608, _e677, (_e677 < _e608));
let _e682 = (_e681 > _e679);
let _e683 = select(0f, _e679, _e682);
let _e685 = (select(0f, _e681, _e682) - _e683);
let _e689 = global_3.member.member_13.member_6;
if (_e689 == 0u) {
phi_1813_ = _e685;
} else {
let _e692 = (_e685 / f32(_e689));
phi_1100_ = 0u;
phi_1103_ = 0f;
loop {
let _e694 = phi_1100_;
let _e696 = phi_1103_;
local_14 = _e696;
let _e699 = ((_e694 < _e689) && (_e685 > 0f));
if _e699 {
let _e702 = (_e683 + (_e692 * f32(_e694)));
let _e703 = (_e702 + _e692);
let _e705 = (0.5f * (_e702 + _e703));
let _e706 = (_e703 - _e702);
let _e707 = (0.28867513f * _e706);
let _e708 = (_e705 - _e707);
let _e718 = global_3.member.member_13.member_7;
let _e719 = bitcast<i32>(_e718);
let _e723 = global_3.member.member_13.member_8;
let _e724 = bitcast<i32>(_e723);
let _e728 = global_3.member.member_13.member_9;
let _e729 = bitcast<i32>(_e728);
let _e730 = f32(_e719);
let _e732 = (_e642.member - _e113.member);
let _e735 = (((((_e164 + (_e610 * _e708)) - _e113.member) / _e732) * _e730) - 0.5f);
let _e736 = (_e730 - 1f);
let _e738 = select(0f, _e735, (_e735 > 0f));
let _e740 = select(_e736, _e738, (_e738 < _e736));
let _e741 = f32(_e724);
let _e743 = (_e642.member_1 - _e113.member_1);
let _e746 = (((((_e165 + (_e612 * _e708)) - _e113.member_1) / _e743) * _e741) - 0.5f);
let _e747 = (_e741 - 1f);
let _e749 = select(0f, _e746, (_e746 > 0f));
let _e751 = select(_e747, _e749, (_e749 < _e747));
let _e752 = f32(_e729);
let _e754 = (_e642.member_2 - _e113.member_2);
let _e757 = (((((_e166 + (_e614 * _e708)) - _e113.member_2) / _e754) * _e752) - 0.5f);
let _e758 = (_e752 - 1f);
let _e760 = select(0f, _e757, (_e757 > 0f));
let _e762 = select(_e758, _e760, (_e760 < _e758));
let _e764 = select(0f, _e740, (_e740 > 0f));
let _e766 = select(1e6f, _e764, (_e764 < 1e6f));
let _e773 = select(0i, select(select(i32(_e766), i32(-2147483648), (_e766 < -2147483600f)), 2147483647i, (_e766 > 2147483500f)), (_e766 == _e766));
let _e777 = (_e773 - select(0i, 1i, (_e766 < f32(_e773))));
let _e779 = select(0f, _e751, (_e751 > 0f));
let _e781 = select(1e6f, _e779, (_e779 < 1e6f));
let _e788 = select(0i, select(select(i32(_e781), i32(-2147483648), (_e781 < -2147483600f)), 2147483647i, (_e781 > 2147483500f)), (_e781 == _e781));
let _e792 = (_e788 - select(0i, 1i, (_e781 < f32(_e788))));
let _e794 = select(0f, _e762, (_e762 > 0f));
let _e796 = select(1e6f, _e794, (_e794 < 1e6f));
let _e803 = select(0i, select(select(i32(_e796), i32(-2147483648), (_e796 < -2147483600f)), 2147483647i, (_e796 > 2147483500f)), (_e796 == _e796));
let _e807 = (_e803 - select(0i, 1i, (_e796 < f32(_e803))));
let _e811 = (_e751 - f32(_e792));
let _e813 = (_e762 - f32(_e807));
local_4 = (_e740 - f32(_e777));
let _e814 = (_e777 + 1i);
let _e816 = select(_e814, 0i, (_e814 < 0i));
if (_e816 >= _e719) {
phi_1238_ = (_e719 - 1i);
} else {
phi_1238_ = _e816;
}
let _e820 = phi_1238_;
local_5 = (_e820 - _e777);
let _e822 = (_e792 + 1i);
let _e824 = select(_e822, 0i, (_e822 < 0i));
if (_e824 >= _e724) {
phi_1251_ = (_e724 - 1i);
} else {
phi_1251_ = _e824;
}
let _e828 = phi_1251_;
let _e830 = ((_e828 - _e792) * _e719);
let _e831 = (_e807 + 1i);
let _e833 = select(_e831, 0i, (_e831 < 0i));
if (_e833 >= _e729) {
phi_1265_ = (_e729 - 1i);
} else {
phi_1265_ = _e833;
}
let _e837 = phi_1265_;
let _e844 = global_3.member.member_13.member_10;
let _e845 = bitcast<i32>(_e844);
let _e850 = ((_e845 + (((_e807 * _e724) + _e792) * _e719)) + _e777);
let _e852 = (bitcast<i32>(_e89) - 1i);
let _e854 = select(_e852, _e850, (_e850 < _e852));
let _e859 = global_1.member[bitcast<u32>(select(0i, _e854, (_e854 > 0i)))];
let _e860 = local_4;
let _e863 = local_5;
let _e864 = (_e850 + _e863);
let _e866 = select(_e852, _e864, (_e864 < _e852));
let _e871 = global_1.member[bitcast<u32>(select(0i, _e866, (_e866 > 0i)))];
let _e872 = local_4;
let _e875 = (1f - _e811);
let _e877 = (_e850 + _e830);
let _e879 = select(_e852, _e877, (_e877 < _e852));
let _e884 = global_1.member[bitcast<u32>(select(0i, _e879, (_e879 > 0i)))];
let _e885 = local_4;
let _e888 = local_5;
let _e889 = (_e877 + _e888);
let _e891 = select(_e852, _e889, (_e889 < _e852));
let _e896 = global_1.member[bitcast<u32>(select(0i, _e891, (_e891 > 0i)))];
let _e897 = local_4;
let _e902 = (_e850 + (((_e837 - _e807) * _e719) * _e724));
let _e904 = select(_e852, _e902, (_e902 < _e852));
let _e909 = global_1.member[bitcast<u32>(select(0i, _e904, (_e904 > 0i)))];
let _e910 = local_4;
let _e913 = local_5;
let _e914 = (_e902 + _e913);
let _e916 = select(_e852, _e914, (_e914 < _e852));
let _e921 = global_1.member[bitcast<u32>(select(0i, _e916, (_e916 > 0i)))];
let _e922 = local_4;
let _e926 = (_e902 + _e830);
let _e928 = select(_e852, _e926, (_e926 < _e852));
let _e933 = global_1.member[bitcast<u32>(select(0i, _e928, (_e928 > 0i)))];
let _e934 = local_4;
let _e937 = local_5;
let _e938 = (_e926 + _e937);
let _e940 = select(_e852, _e938, (_e938 < _e852));
let _e945 = global_1.member[bitcast<u32>(select(0i, _e940, (_e940 > 0i)))];
let _e946 = local_4;
let _e955 = (_e705 + _e707);
let _e965 = (((((_e164 + (_e610 * _e955)) - _e113.member) / _e732) * _e730) - 0.5f);
let _e967 = select(0f, _e965, (_e965 > 0f));
let _e969 = select(_e736, _e967, (_e967 < _e736));
let _e973 = (((((_e165 + (_e612 * _e955)) - _e113.member_1) / _e743) * _e741) - 0.5f);
let _e975 = select(0f, _e973, (_e973 > 0f));
let _e977 = select(_e747, _e975, (_e975 < _e747));
let _e981 = (((((_e166 + (_e614 * _e955)) - _e113.member_2) / _e754) * _e752) - 0.5f);
let _e983 = select(0f, _e981, (_e981 > 0f));
let _e985 = select(_e758, _e983, (_e983 < _e758));
let _e987 = select(0f, _e969, (_e969 > 0f));
let _e989 = select(1e6f, _e987, (_e987 < 1e6f));
let _e996 = select(0i, select(select(i32(_e989), i32(-2147483648), (_e989 < -2147483600f)), 2147483647i, (_e989 > 2147483500f)), (_e989 == _e989));
let _e1000 = (_e996 - select(0i, 1i, (_e989 < f32(_e996))));
let _e1002 = select(0f, _e977, (_e977 > 0f));
let _e1004 = select(1e6f, _e1002, (_e1002 < 1e6f));
let _e1011 = select(0i, select(select(i32(_e1004), i32(-2147483648), (_e1004 < -2147483600f)), 2147483647i, (_e1004 > 2147483500f)), (_e1004 == _e1004));
let _e1015 = (_e1011 - select(0i, 1i, (_e1004 < f32(_e1011))));
let _e1017 = select(0f, _e985, (_e985 > 0f));
let _e1019 = select(1e6f, _e1017, (_e1017 < 1e6f));
let _e1026 = select(0i, select(select(i32(_e1019), i32(-2147483648), (_e1019 < -2147483600f)), 2147483647i, (_e1019 > 2147483500f)), (_e1019 == _e1019));
let _e1030 = (_e1026 - select(0i, 1i, (_e1019 < f32(_e1026))));
let _e1034 = (_e977 - f32(_e1015));
let _e1036 = (_e985 - f32(_e1030));
local_2 = (_e969 - f32(_e1000));
let _e1037 = (_e1000 + 1i);
let _e1039 = select(_e1037, 0i, (_e1037 < 0i));
if (_e1039 >= _e719) {
phi_1581_ = (_e719 - 1i);
} else {
phi_1581_ = _e1039;
}
let _e1043 = phi_1581_;
local_3 = (_e1043 - _e1000);
let _e1045 = (_e1015 + 1i);
let _e1047 = select(_e1045, 0i, (_e1045 < 0i));
if (_e1047 >= _e724) {
phi_1594_ = (_e724 - 1i);
} else {
phi_1594_ = _e1047;
}
let _e1051 = phi_1594_;
let _e1053 = ((_e1051 - _e1015) * _e719);
let _e1054 = (_e1030 + 1i);
let _e1056 = select(_e1054, 0i, (_e1054 < 0i));
if (_e1056 >= _e729) {
phi_1608_ = (_e729 - 1i);
} else {
phi_1608_ = _e1056;
}
let _e1060 = phi_1608_;
let _e1068 = ((_e845 + (((_e1030 * _e724) + _e1015) * _e719)) + _e1000);
let _e1070 = select(_e852, _e1068, (_e1068 < _e852));
let _e1075 = global_1.member[bitcast<u32>(select(0i, _e1070, (_e1070 > 0i)))];
let _e1076 = local_2;
let _e1079 = local_3;
let _e1080 = (_e1068 + _e1079);
let _e1082 = select(_e852, _e1080, (_e1080 < _e852));
let _e1087 = global_1.member[bitcast<u32>(select(0i, _e1082, (_e1082 > 0i)))];
let _e1088 = local_2;
let _e1091 = (1f - _e1034);
let _e1093 = (_e1068 + _e1053);
let _e1095 = select(_e852, _e1093, (_e1093 < _e852));
let _e1100 = global_1.member[bitcast<u32>(select(0i, _e1095, (_e1095 > 0i)))];
let _e1101 = local_2;
let _e1104 = local_3;
let _e1105 = (_e1093 + _e1104);
let _e1107 = select(_e852, _e1105, (_e1105 < _e852));
let _e1112 = global_1.member[bitcast<u32>(select(0i, _e1107, (_e1107 > 0i)))];
let _e1113 = local_2;
let _e1118 = (_e1068 + (((_e1060 - _e1030) * _e719) * _e724));
let _e1120 = select(_e852, _e1118, (_e1118 < _e852));
let _e1125 = global_1.member[bitcast<u32>(select(0i, _e1120, (_e1120 > 0i)))];
let _e1126 = local_2;
let _e1129 = local_3;
let _e1130 = (_e1118 + _e1129);
let _e1132 = select(_e852, _e1130, (_e1130 < _e852));
let _e1137 = global_1.member[bitcast<u32>(select(0i, _e1132, (_e1132 > 0i)))];
let _e1138 = local_2;
let _e1142 = (_e1118 + _e1053);
let _e1144 = select(_e852, _e1142, (_e1142 < _e852));
let _e1149 = global_1.member[bitcast<u32>(select(0i, _e1144, (_e1144 > 0i)))];
let _e1150 = local_2;
let _e1153 = local_3;
let _e1154 = (_e1142 + _e1153);
let _e1156 = select(_e852, _e1154, (_e1154 < _e852));
let _e1161 = global_1.member[bitcast<u32>(select(0i, _e1156, (_e1156 > 0i)))];
let _e1162 = local_2;
phi_1101_ = (_e694 + 1u);
phi_1104_ = (_e696 + ((0.5f * (((((((_e859 * (1f - _e860)) + (_e871 * _e872)) * _e875) + (((_e884 * (1f - _e885)) + (_e896 * _e897)) * _e811)) * (1f - _e813)) + (((((_e909 * (1f - _e910)) + (_e921 * _e922)) * _e875) + (((_e933 * (1f - _e934)) + (_e945 * _e946)) * _e811)) * _e813)) + ((((((_e1075 * (1f - _e1076)) + (_e1087 * _e1088)) * _e1091) + (((_e1100 * (1f - _e1101)) + (_e1112 * _e1113)) * _e1034)) * (1f - _e1036)) + (((((_e1125 * (1f - _e1126)) + (_e1137 * _e1138)) * _e1091) + (((_e1149 * (1f - _e1150)) + (_e1161 * _e1162)) * _e1034)) * _e1036)))) * _e706));
} else {
phi_1101_ = u32();
phi_1104_ = f32();
}
let _e1177 = phi_1101_;
let _e1179 = phi_1104_;
continue;
continuing {
phi_1100_ = _e1177;
phi_1103_ = _e1179;
break if !(_e699);
}
}
let _e2125 = local_14;
phi_1813_ = _e2125;
}
let _e1182 = phi_1813_;
let _e1187 = global_3.member.member_13.member;
let _e1192 = -((_e1187.member * _e1182));
let _e1194 = select(-87f, _e1192, (_e1192 > -87f));
let _e1196 = select(88f, _e1194, (_e1194 < 88f));
let _e1198 = ((_e1196 * 1.442695f) + 0.5f);
let _e1200 = select(-127f, _e1198, (_e1198 > -127f));
let _e1202 = select(128f, _e1200, (_e1200 < 128f));
let _e1209 = select(0i, select(select(i32(_e1202), i32(-2147483648), (_e1202 < -2147483600f)), 2147483647i, (_e1202 > 2147483500f)), (_e1202 == _e1202));
let _e1213 = (_e1209 - select(0i, 1i, (_e1202 < f32(_e1209))));
let _e1214 = f32(_e1213);
let _e1218 = ((_e1196 - (_e1214 * 0.6933594f)) - (_e1214 * -2.1219444e-4f));
let _e1240 = -((_e1187.member_1 * _e1182));
let _e1242 = select(-87f, _e1240, (_e1240 > -87f));
let _e1244 = select(88f, _e1242, (_e1242 < 88f));
let _e1246 = ((_e1244 * 1.442695f) + 0.5f);
let _e1248 = select(-127f, _e1246, (_e1246 > -127f));
let _e1250 = select(128f, _e1248, (_e1248 < 128f));
let _e1257 = select(0i, select(select(i32(_e1250), i32(-2147483648), (_e1250 < -2147483600f)), 2147483647i, (_e1250 > 2147483500f)), (_e1250 == _e1250));
let _e1261 = (_e1257 - select(0i, 1i, (_e1250 < f32(_e1257))));
let _e1262 = f32(_e1261);
let _e1266 = ((_e1244 - (_e1262 * 0.6933594f)) - (_e1262 * -2.1219444e-4f));
let _e1288 = -((_e1187.member_2 * _e1182));
let _e1290 = select(-87f, _e1288, (_e1288 > -87f));
let _e1292 = select(88f, _e1290, (_e1290 < 88f));
let _e1294 = ((_e1292 * 1.442695f) + 0.5f);
let _e1296 = select(-127f, _e1294, (_e1294 > -127f));
let _e1298 = select(128f, _e1296, (_e1296 < 128f));
let _e1305 = select(0i, select(select(i32(_e1298), i32(-2147483648), (_e1298 < -2147483600f)), 2147483647i, (_e1298 > 2147483500f)), (_e1298 == _e1298));
let _e1309 = (_e1305 - select(0i, 1i, (_e1298 < f32(_e1305))));
let _e1310 = f32(_e1309);
let _e1314 = ((_e1292 - (_e1310 * 0.6933594f)) - (_e1310 * -2.1219444e-4f));
let _e1336 = (_e595.member_1.x * ((1f + (_e1218 * (1f + (_e1218 * (0.5f + (_e1218 * (0.16666667f + (_e1218 * (0.041666668f + (_e1218 * (0.008333334f + (_e1218 * (0.001388889f + (_e1218 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1213 + 127i)) << bitcast<u32>(23i)))));
let _e1338 = (_e595.member_1.y * ((1f + (_e1266 * (1f + (_e1266 * (0.5f + (_e1266 * (0.16666667f + (_e1266 * (0.041666668f + (_e1266 * (0.008333334f + (_e1266 * (0.001388889f + (_e1266 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1261 + 127i)) << bitcast<u32>(23i)))));
let _e1340 = (_e595.member_1.z * ((1f + (_e1314 * (1f + (_e1314 * (0.5f + (_e1314 * (0.16666667f + (_e1314 * (0.041666668f + (_e1314 * (0.008333334f + (_e1314 * (0.001388889f + (_e1314 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1309 + 127i)) << bitcast<u32>(23i)))));
let _e1350 = (((_e1336 + _e1338) + _e1340) * _e130);
phi_2043_ = vec3<f32>((_e140.x + (_e595.member.x * _e1350)), (_e140.y + (_e595.member.y * _e1350)), (_e140.z + (_e595.member.z * _e1350)));
phi_2044_ = vec3<f32>((_e142.x + _e1336), (_e142.y + _e1338), (_e142.z + _e1340));
phi_2045_ = (_e146 + 1f);
} else {
phi_2043_ = _e140;
phi_2044_ = _e142;
phi_2045_ = _e146;
}
let _e1363 = phi_2043_;
let _e1365 = phi_2044_;
let _e1367 = phi_2045_;
phi_275_ = _e1363;
phi_278_ = _e1365;
phi_280_ = (_e144 + 1u);
phi_282_ = _e1367;
} else {
phi_275_ = vec3<f32>();
phi_278_ = vec3<f32>();
phi_280_ = u32();
phi_282_ = f32();
}
let _e1370 = phi_275_;
let _e1372 = phi_278_;
let _e1374 = phi_280_;
let _e1376 = phi_282_;
continue;
continuing {
phi_274_ = _e1370;
phi_277_ = _e1372;
phi_279_ = _e1374;
phi_281_ = _e1376;
break if !(_e147);
}
}
let _e1378 = (1f / 27f);
let _e1383 = global_3.member.member_19.member.member;
let _e1388 = global_3.member.member_19.member.member_1;
let _e1393 = global_3.member.member_19.member.member_2;
let _e1397 = global_3.member.member_19.member_1;
let _e1401 = (1f / (_e1397 * ((_e1383 * _e1388) * _e1393)));
let _e1405 = bitcast<i32>((((_e81.y * 16u) + _e81.x) * 12u));
let _e1407 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1409 = select(_e1407, _e1405, (_e1405 < _e1407));
let _e1415 = global_5.member[bitcast<u32>(select(0i, _e1409, (_e1409 > 0i)))];
let _e1416 = (_e1405 + 1i);
let _e1418 = select(_e1407, _e1416, (_e1416 < _e1407));
let _e1424 = global_5.member[bitcast<u32>(select(0i, _e1418, (_e1418 > 0i)))];
let _e1427 = ((_e1424 >> bitcast<u32>(31i)) != 0u);
if _e1427 {
phi_2109_ = (~(_e1415) + 1u);
} else {
phi_2109_ = _e1415;
}
let _e1433 = phi_2109_;
if _e1427 {
phi_2115_ = (~(_e1424) + select(0u, 1u, (_e1415 == 0u)));
} else {
phi_2115_ = _e1424;
}
let _e1437 = phi_2115_;
let _e1459 = ((((f32(bitcast<i32>(((_e1437 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1437 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1433 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1433 & 65535u)))));
let _e1465 = (_e1405 + 2i);
let _e1467 = select(_e1407, _e1465, (_e1465 < _e1407));
let _e1473 = global_5.member[bitcast<u32>(select(0i, _e1467, (_e1467 > 0i)))];
let _e1474 = (_e1405 + 3i);
let _e1476 = select(_e1407, _e1474, (_e1474 < _e1407));
let _e1482 = global_5.member[bitcast<u32>(select(0i, _e1476, (_e1476 > 0i)))];
let _e1485 = ((_e1482 >> bitcast<u32>(31i)) != 0u);
if _e1485 {
phi_2177_ = (~(_e1473) + 1u);
} else {
phi_2177_ = _e1473;
}
let _e1491 = phi_2177_;
if _e1485 {
phi_2183_ = (~(_e1482) + select(0u, 1u, (_e1473 == 0u)));
} else {
phi_2183_ = _e1482;
}
let _e1495 = phi_2183_;
let _e1517 = ((((f32(bitcast<i32>(((_e1495 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1495 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1491 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1491 & 65535u)))));
let _e1523 = (_e1405 + 4i);
let _e1525 = select(_e1407, _e1523, (_e1523 < _e1407));
let _e1531 = global_5.member[bitcast<u32>(select(0i, _e1525, (_e1525 > 0i)))];
let _e1532 = (_e1405 + 5i);
let _e1534 = select(_e1407, _e1532, (_e1532 < _e1407));
let _e1540 = global_5.member[bitcast<u32>(select(0i, _e1534, (_e1534 > 0i)))];
let _e1543 = ((_e1540 >> bitcast<u32>(31i)) != 0u);
if _e1543 {
phi_2245_ = (~(_e1531) + 1u);
} else {
phi_2245_ = _e1531;
}
let _e1549 = phi_2245_;
if _e1543 {
phi_2251_ = (~(_e1540) + select(0u, 1u, (_e1531 == 0u)));
} else {
phi_2251_ = _e1540;
}
let _e1553 = phi_2251_;
let _e1575 = ((((f32(bitcast<i32>(((_e1553 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1553 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1549 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1549 & 65535u)))));
let _e1581 = (_e1405 + 6i);
let _e1583 = select(_e1407, _e1581, (_e1581 < _e1407));
let _e1589 = global_5.member[bitcast<u32>(select(0i, _e1583, (_e1583 > 0i)))];
let _e1590 = (_e1405 + 7i);
let _e1592 = select(_e1407, _e1590, (_e1590 < _e1407));
let _e1598 = global_5.member[bitcast<u32>(select(0i, _e1592, (_e1592 > 0i)))];
let _e1601 = ((_e1598 >> bitcast<u32>(31i)) != 0u);
if _e1601 {
phi_2313_ = (~(_e1589) + 1u);
} else {
phi_2313_ = _e1589;
}
let _e1607 = phi_2313_;
if _e1601 {
phi_2319_ = (~(_e1598) + select(0u, 1u, (_e1589 == 0u)));
} else {
phi_2319_ = _e1598;
}
let _e1611 = phi_2319_;
let _e1633 = ((((f32(bitcast<i32>(((_e1611 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1611 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1607 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1607 & 65535u)))));
let _e1639 = (_e1405 + 8i);
let _e1641 = select(_e1407, _e1639, (_e1639 < _e1407));
let _e1647 = global_5.member[bitcast<u32>(select(0i, _e1641, (_e1641 > 0i)))];
let _e1648 = (_e1405 + 9i);
let _e1650 = select(_e1407, _e1648, (_e1648 < _e1407));
let _e1656 = global_5.member[bitcast<u32>(select(0i, _e1650, (_e1650 > 0i)))];
let _e1659 = ((_e1656 >> bitcast<u32>(31i)) != 0u);
if _e1659 {
phi_2381_ = (~(_e1647) + 1u);
} else {
phi_2381_ = _e1647;
}
let _e1665 = phi_2381_;
if _e1659 {
phi_2387_ = (~(_e1656) + select(0u, 1u, (_e1647 == 0u)));
} else {
phi_2387_ = _e1656;
}
let _e1669 = phi_2387_;
let _e1691 = ((((f32(bitcast<i32>(((_e1669 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1669 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1665 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1665 & 65535u)))));
let _e1697 = (_e1405 + 10i);
let _e1699 = select(_e1407, _e1697, (_e1697 < _e1407));
let _e1705 = global_5.member[bitcast<u32>(select(0i, _e1699, (_e1699 > 0i)))];
let _e1706 = (_e1405 + 11i);
let _e1708 = select(_e1407, _e1706, (_e1706 < _e1407));
let _e1714 = global_5.member[bitcast<u32>(select(0i, _e1708, (_e1708 > 0i)))];
let _e1717 = ((_e1714 >> bitcast<u32>(31i)) != 0u);
if _e1717 {
phi_2449_ = (~(_e1705) + 1u);
} else {
phi_2449_ = _e1705;
}
let _e1723 = phi_2449_;
if _e1717 {
phi_2455_ = (~(_e1714) + select(0u, 1u, (_e1705 == 0u)));
} else {
phi_2455_ = _e1714;
}
let _e1727 = phi_2455_;
let _e1749 = ((((f32(bitcast<i32>(((_e1727 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1727 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1723 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1723 & 65535u)))));
let _e1758 = global_3.member.member_13.member_6;
if (_e1758 == 0u) {
phi_2819_ = 1f;
} else {
let _e1763 = global_3.member.member_13.member_7;
let _e1764 = bitcast<i32>(_e1763);
let _e1768 = global_3.member.member_13.member_8;
let _e1769 = bitcast<i32>(_e1768);
let _e1773 = global_3.member.member_13.member_9;
let _e1774 = bitcast<i32>(_e1773);
let _e1778 = global_3.member.member_13.member_5;
let _e1782 = f32(_e1764);
let _e1787 = ((((_e127 - _e113.member) / (_e1778.member - _e113.member)) * _e1782) - 0.5f);
let _e1788 = (_e1782 - 1f);
let _e1790 = select(0f, _e1787, (_e1787 > 0f));
let _e1792 = select(_e1788, _e1790, (_e1790 < _e1788));
let _e1793 = f32(_e1769);
let _e1798 = ((((_e128 - _e113.member_1) / (_e1778.member_1 - _e113.member_1)) * _e1793) - 0.5f);
let _e1799 = (_e1793 - 1f);
let _e1801 = select(0f, _e1798, (_e1798 > 0f));
let _e1803 = select(_e1799, _e1801, (_e1801 < _e1799));
let _e1804 = f32(_e1774);
let _e1809 = ((((_e129 - _e113.member_2) / (_e1778.member_2 - _e113.member_2)) * _e1804) - 0.5f);
let _e1810 = (_e1804 - 1f);
let _e1812 = select(0f, _e1809, (_e1809 > 0f));
let _e1814 = select(_e1810, _e1812, (_e1812 < _e1810));
let _e1816 = select(0f, _e1792, (_e1792 > 0f));
let _e1818 = select(1e6f, _e1816, (_e1816 < 1e6f));
let _e1825 = select(0i, select(select(i32(_e1818), i32(-2147483648), (_e1818 < -2147483600f)), 2147483647i, (_e1818 > 2147483500f)), (_e1818 == _e1818));
let _e1829 = (_e1825 - select(0i, 1i, (_e1818 < f32(_e1825))));
let _e1831 = select(0f, _e1803, (_e1803 > 0f));
let _e1833 = select(1e6f, _e1831, (_e1831 < 1e6f));
let _e1840 = select(0i, select(select(i32(_e1833), i32(-2147483648), (_e1833 < -2147483600f)), 2147483647i, (_e1833 > 2147483500f)), (_e1833 == _e1833));
let _e1844 = (_e1840 - select(0i, 1i, (_e1833 < f32(_e1840))));
let _e1846 = select(0f, _e1814, (_e1814 > 0f));
let _e1848 = select(1e6f, _e1846, (_e1846 < 1e6f));
let _e1855 = select(0i, select(select(i32(_e1848), i32(-2147483648), (_e1848 < -2147483600f)), 2147483647i, (_e1848 > 2147483500f)), (_e1848 == _e1848));
let _e1859 = (_e1855 - select(0i, 1i, (_e1848 < f32(_e1855))));
let _e1863 = (_e1803 - f32(_e1844));
let _e1865 = (_e1814 - f32(_e1859));
local = (_e1792 - f32(_e1829));
let _e1866 = (_e1829 + 1i);
let _e1868 = select(_e1866, 0i, (_e1866 < 0i));
if (_e1868 >= _e1764) {
phi_2592_ = (_e1764 - 1i);
} else {
phi_2592_ = _e1868;
}
let _e1872 = phi_2592_;
local_1 = (_e1872 - _e1829);
let _e1874 = (_e1844 + 1i);
let _e1876 = select(_e1874, 0i, (_e1874 < 0i));
if (_e1876 >= _e1769) {
phi_2605_ = (_e1769 - 1i);
} else {
phi_2605_ = _e1876;
}
let _e1880 = phi_2605_;
let _e1882 = ((_e1880 - _e1844) * _e1764);
let _e1883 = (_e1859 + 1i);
let _e1885 = select(_e1883, 0i, (_e1883 < 0i));
if (_e1885 >= _e1774) {
phi_2619_ = (_e1774 - 1i);
} else {
phi_2619_ = _e1885;
}
let _e1889 = phi_2619_;
let _e1896 = global_3.member.member_13.member_10;
let _e1902 = ((bitcast<i32>(_e1896) + (((_e1859 * _e1769) + _e1844) * _e1764)) + _e1829);
let _e1904 = (bitcast<i32>(_e89) - 1i);
let _e1906 = select(_e1904, _e1902, (_e1902 < _e1904));
let _e1911 = global_1.member[bitcast<u32>(select(0i, _e1906, (_e1906 > 0i)))];
let _e1912 = local;
let _e1915 = local_1;
let _e1916 = (_e1902 + _e1915);
let _e1918 = select(_e1904, _e1916, (_e1916 < _e1904));
let _e1923 = global_1.member[bitcast<u32>(select(0i, _e1918, (_e1918 > 0i)))];
let _e1924 = local;
let _e1927 = (1f - _e1863);
let _e1929 = (_e1902 + _e1882);
let _e1931 = select(_e1904, _e1929, (_e1929 < _e1904));
let _e1936 = global_1.member[bitcast<u32>(select(0i, _e1931, (_e1931 > 0i)))];
let _e1937 = local;
let _e1940 = local_1;
let _e1941 = (_e1929 + _e1940);
let _e1943 = select(_e1904, _e1941, (_e1941 < _e1904));
let _e1948 = global_1.member[bitcast<u32>(select(0i, _e1943, (_e1943 > 0i)))];
let _e1949 = local;
let _e1954 = (_e1902 + (((_e1889 - _e1859) * _e1764) * _e1769));
let _e1956 = select(_e1904, _e1954, (_e1954 < _e1904));
let _e1961 = global_1.member[bitcast<u32>(select(0i, _e1956, (_e1956 > 0i)))];
let _e1962 = local;
let _e1965 = local_1;
let _e1966 = (_e1954 + _e1965);
let _e1968 = select(_e1904, _e1966, (_e1966 < _e1904));
let _e1973 = global_1.member[bitcast<u32>(select(0i, _e1968, (_e1968 > 0i)))];
let _e1974 = local;
let _e1978 = (_e1954 + _e1882);
let _e1980 = select(_e1904, _e1978, (_e1978 < _e1904));
let _e1985 = global_1.member[bitcast<u32>(select(0i, _e1980, (_e1980 > 0i)))];
let _e1986 = local;
let _e1989 = local_1;
let _e1990 = (_e1978 + _e1989);
let _e1992 = select(_e1904, _e1990, (_e1990 < _e1904));
let _e1997 = global_1.member[bitcast<u32>(select(0i, _e1992, (_e1992 > 0i)))];
let _e1998 = local;
phi_2819_ = ((((((_e1911 * (1f - _e1912)) + (_e1923 * _e1924)) * _e1927) + (((_e1936 * (1f - _e1937)) + (_e1948 * _e1949)) * _e1863)) * (1f - _e1865)) + (((((_e1961 * (1f - _e1962)) + (_e1973 * _e1974)) * _e1927) + (((_e1985 * (1f - _e1986)) + (_e1997 * _e1998)) * _e1863)) * _e1865));
}
let _e2008 = phi_2819_;
let _e2010 = local_7;
let _e2014 = local_8;
let _e2018 = local_9;
let _e2024 = ((_e2010.x * _e1378) + (select(_e1459, -(bitcast<f32>((bitcast<u32>(_e1459) & 2147483647u))), _e1427) * _e1401));
let _e2025 = ((_e2014.y * _e1378) + (select(_e1517, -(bitcast<f32>((bitcast<u32>(_e1517) & 2147483647u))), _e1485) * _e1401));
let _e2026 = ((_e2018.z * _e1378) + (select(_e1575, -(bitcast<f32>((bitcast<u32>(_e1575) & 2147483647u))), _e1543) * _e1401));
let _e2028 = local_10;
let _e2032 = local_11;
let _e2036 = local_12;
let _e2042 = ((_e2028.x * _e1378) + (select(_e1633, -(bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u))), _e1601) * _e1401));
let _e2043 = ((_e2032.y * _e1378) + (select(_e1691, -(bitcast<f32>((bitcast<u32>(_e1691) & 2147483647u))), _e1659) * _e1401));
let _e2044 = ((_e2036.z * _e1378) + (select(_e1749, -(bitcast<f32>((bitcast<u32>(_e1749) & 2147483647u))), _e1717) * _e1401));
let _e2046 = local_13;
let _e2050 = select(0f, _e2024, (_e2024 > 0f));
let _e2052 = select(0f, _e2025, (_e2025 > 0f));
let _e2054 = select(0f, _e2026, (_e2026 > 0f));
let _e2057 = (((_e2050 + _e2052) + _e2054) * _e130);
let _e2062 = (((_e2042 * _e2042) + (_e2043 * _e2043)) + (_e2044 * _e2044));
let _e2065 = sqrt(select(0f, _e2062, (_e2062 > 0f)));
let _e2068 = (1f / select(1e-30f, _e2065, (_e2065 > 1e-30f)));
let _e2074 = (_e2065 / select(1e-30f, _e2057, (_e2057 > 1e-30f)));
global_2.member[_e101] = _e2050;
global_2.member[(_e99 + _e101)] = _e2052;
global_2.member[((2u * _e99) + _e101)] = _e2054;
global_2.member[((3u * _e99) + _e101)] = (_e2042 * _e2068);
global_2.member[((4u * _e99) + _e101)] = (_e2043 * _e2068);
global_2.member[((5u * _e99) + _e101)] = (_e2044 * _e2068);
global_2.member[((6u * _e99) + _e101)] = select(1f, _e2074, (_e2074 < 1f));
global_2.member[((7u * _e99) + _e101)] = (_e2008 * (_e2046 * _e1378));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
