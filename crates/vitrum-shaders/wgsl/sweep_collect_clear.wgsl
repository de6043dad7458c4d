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
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: array<u32>,
}
struct type_21 {
member: vec3<f32>,
member_1: f32,
}
struct type_22 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_23 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_24 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_25 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_26 {
member: type_5,
member_1: type_5,
}
struct type_27 {
member: type_7,
member_1: u32,
}
struct type_28 {
member: type_2,
member_1: u32,
member_2: type_22,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_23,
member_8: type_24,
member_9: type_24,
member_10: type_25,
member_11: type_26,
member_12: type_14,
member_13: type_23,
member_14: type_4,
member_15: type_9,
member_16: type_27,
member_17: type_27,
member_18: type_27,
member_19: type_27,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_29 {
member: type_28,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_16;
@group(0) @binding(0)
var<storage> global_2: type_29;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_20;
@group(0) @binding(3)
var<storage> global_5: type_20;
fn function_() {
var phi_1683_: u32;
var phi_1684_: u32;
var phi_245_: i32;
var phi_422_: f32;
var phi_456_: f32;
var phi_491_: f32;
var phi_526_: f32;
var phi_636_: f32;
var phi_690_: i32;
var phi_734_: i32;
var phi_860_: vec3<f32>;
var phi_915_: i32;
var phi_1044_: vec3<f32>;
var phi_1079_: i32;
var phi_1207_: vec3<f32>;
var phi_1254_: i32;
var phi_1382_: vec3<f32>;
var phi_1418_: i32;
var phi_1545_: vec3<f32>;
var phi_1643_: i32;
var phi_1794_: type_21;
let _e51 = global;
let _e55 = arrayLength((&global_3.member));
let _e60 = global_2.member.member_2;
let _e63 = global_2.member.member;
let _e71 = (_e51.x + _e60.member);
let _e73 = (_e51.y + _e60.member_1);
if (_e71 < _e60.member_2) {
if (_e73 < _e60.member_3) {
let _e78 = ((_e73 * _e63.member) + _e71);
let _e83 = global_2.member.member.member;
let _e85 = ((_e73 * _e83) + _e71);
let _e86 = (_e85 / 81u);
let _e88 = (_e85 - (_e86 * 81u));
let _e89 = (_e88 / 9u);
let _e93 = global_2.member.member_12.member_16;
let _e95 = bitcast<i32>((_e93 + _e86));
let _e97 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e99 = select(_e97, _e95, (_e95 < _e97));
let _e105 = global_5.member[bitcast<u32>(select(0i, _e99, (_e99 > 0i)))];
let _e115 = ((bitcast<i32>((_e105 & 65535u)) * 8i) + bitcast<i32>((_e88 - (_e89 * 9u))));
let _e118 = ((bitcast<i32>((_e105 >> bitcast<u32>(16i))) * 8i) + bitcast<i32>(_e89));
let _e120 = (_e63.member_2 == 5u);
if ((((_e63.member_2 == 1u) || _e120) || (_e63.member_2 == 6u)) || ((_e63.member_2 == 2u) || (_e63.member_2 == 7u))) {
let _e226 = global_2.member.member_12.member_4.member;
let _e227 = bitcast<i32>(_e226);
let _e232 = global_2.member.member_12.member_4.member_1;
let _e233 = bitcast<i32>(_e232);
let _e240 = ((((_e115 >= 0i) && (_e115 < _e227)) && (_e118 >= 0i)) && (_e118 < _e233));
if _e240 {
phi_245_ = ((_e118 * _e227) + _e115);
} else {
phi_245_ = 0i;
}
let _e244 = phi_245_;
let _e245 = (_e227 * _e233);
let _e247 = (bitcast<i32>(_e55) - 1i);
let _e249 = select(_e247, _e244, (_e244 < _e247));
let _e255 = global_3.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e258 = select(0f, 1f, (_e240 && (_e255 == 32f)));
let _e260 = ((3i * _e245) + _e244);
let _e262 = select(_e247, _e260, (_e260 < _e247));
let _e268 = global_3.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e270 = ((4i * _e245) + _e244);
let _e272 = select(_e247, _e270, (_e270 < _e247));
let _e278 = global_3.member[bitcast<u32>(select(0i, _e272, (_e272 > 0i)))];
let _e280 = ((5i * _e245) + _e244);
let _e282 = select(_e247, _e280, (_e280 < _e247));
let _e288 = global_3.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e290 = ((6i * _e245) + _e244);
let _e292 = select(_e247, _e290, (_e290 < _e247));
let _e298 = global_3.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e300 = ((7i * _e245) + _e244);
let _e302 = select(_e247, _e300, (_e300 < _e247));
let _e308 = global_3.member[bitcast<u32>(select(0i, _e302, (_e302 > 0i)))];
let _e317 = f32(_e115);
let _e318 = f32(_e118);
let _e322 = global_2.member.member_12.member_3;
let _e323 = (_e322 == 0u);
if _e323 {
phi_422_ = 1f;
} else {
let _e327 = global_2.member.member_12.member_5;
let _e331 = global_2.member.member_12.member_7;
let _e333 = (_e327 + (_e317 * _e331));
let _e337 = global_2.member.member_12.member_6;
let _e339 = (_e337 + (_e318 * _e331));
let _e344 = (((_e333 * _e333) + (_e339 * _e339)) + (1f * 1f));
let _e348 = (1f / sqrt(select(0f, _e344, (_e344 > 0f))));
phi_422_ = ((_e348 * _e348) * _e348);
}
let _e352 = phi_422_;
let _e353 = (_e317 + 1f);
if _e323 {
phi_456_ = 1f;
} else {
let _e357 = global_2.member.member_12.member_5;
let _e361 = global_2.member.member_12.member_7;
let _e363 = (_e357 + (_e353 * _e361));
let _e367 = global_2.member.member_12.member_6;
let _e369 = (_e367 + (_e318 * _e361));
let _e374 = (((_e363 * _e363) + (_e369 * _e369)) + (1f * 1f));
let _e378 = (1f / sqrt(select(0f, _e374, (_e374 > 0f))));
phi_456_ = ((_e378 * _e378) * _e378);
}
let _e382 = phi_456_;
let _e384 = (_e318 + 1f);
if _e323 {
phi_491_ = 1f;
} else {
let _e388 = global_2.member.member_12.member_5;
let _e392 = global_2.member.member_12.member_7;
let _e394 = (_e388 + (_e317 * _e392));
let _e398 = global_2.member.member_12.member_6;
let _e400 = (_e398 + (_e384 * _e392));
let _e405 = (((_e394 * _e394) + (_e400 * _e400)) + (1f * 1f));
let _e409 = (1f / sqrt(select(0f, _e405, (_e405 > 0f))));
phi_491_ = ((_e409 * _e409) * _e409);
}
let _e413 = phi_491_;
if _e323 {
phi_526_ = 1f;
} else {
let _e417 = global_2.member.member_12.member_5;
let _e421 = global_2.member.member_12.member_7;
let _e423 = (_e417 + (_e353 * _e421));
let _e427 = global_2.member.member_12.member_6;
let _e429 = (_e427 + (_e384 * _e421));
let _e434 = (((_e423 * _e423) + (_e429 * _e429)) + (1f * 1f));
let _e438 = (1f / sqrt(select(0f, _e434, (_e434 > 0f))));
phi_526_ = ((_e438 * _e438) * _e438);
}
let _e442 = phi_526_;
let _e445 = (((_e352 + _e382) + (_e413 + _e442)) * 0.25f);
if _e323 {
phi_636_ = 1f;
} else {
let _e451 = global_2.member.member_12.member_5;
let _e455 = global_2.member.member_12.member_7;
let _e457 = (_e451 + ((_e317 + 0.5f) * _e455));
let _e461 = global_2.member.member_12.member_6;
let _e463 = (_e461 + ((_e318 + 0.5f) * _e455));
let _e468 = global_2.member.member_12.member_20.member;
let _e476 = (((_e468.member * _e457) + (_e468.member_1 * _e463)) + (_e468.member_2 * 1f));
let _e480 = (_e457 - (_e468.member * _e476));
let _e481 = (_e463 - (_e468.member_1 * _e476));
let _e482 = (1f - (_e468.member_2 * _e476));
let _e487 = (((_e480 * _e480) + (_e481 * _e481)) + (_e482 * _e482));
let _e498 = global_2.member.member_12.member_20.member_1;
let _e504 = global_2.member.member_12.member_20.member_2;
let _e505 = ((_e498 - (sqrt(select(0f, _e487, (_e487 > 0f))) / select(1e-20f, _e476, (_e476 > 1e-20f)))) * _e504);
let _e507 = select(0f, _e505, (_e505 > 0f));
let _e509 = select(1f, _e507, (_e507 < 1f));
phi_636_ = select(1f, select(0f, ((_e509 * _e509) * (3f - (2f * _e509))), (_e476 > 0f)), (_e504 > 0f));
}
let _e519 = phi_636_;
let _e521 = select((_e445 * _e519), 1f, _e240);
let _e528 = global_2.member.member_12.member_15;
let _e529 = bitcast<i32>(_e528);
let _e531 = (firstTrailingBit(8u) & 31u);
let _e533 = (_e115 >> bitcast<u32>(_e531));
let _e535 = (_e118 >> bitcast<u32>(_e531));
let _e540 = global_2.member.member_12.member_14.member;
let _e541 = bitcast<i32>(_e540);
let _e546 = global_2.member.member_12.member_14.member_1;
let _e547 = bitcast<i32>(_e546);
let _e552 = global_2.member.member_12.member_14.member_2;
if ((((((_e533 >= 0i) && (_e533 < _e541)) && (_e535 >= 0i)) && (_e535 < _e547)) && (_e529 >= 0i)) && (_e529 < bitcast<i32>(_e552))) {
phi_690_ = (((((_e529 * _e547) + _e535) * _e541) + _e533) * 3i);
} else {
phi_690_ = -1i;
}
let _e571 = phi_690_;
let _e572 = (_e571 + 2i);
let _e574 = select(_e97, _e572, (_e572 < _e97));
let _e580 = global_5.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e581 = bitcast<i32>(_e580);
if ((_e571 < 0i) || (_e581 == 0i)) {
phi_734_ = -1i;
} else {
let _e596 = global_2.member.member_12.member_17.member;
let _e601 = global_2.member.member_12.member_17.member_1;
phi_734_ = (bitcast<i32>((_e596 * _e601)) + ((((_e581 - 1i) * 64i) + ((_e118 & 7i) * 8i)) + (_e115 & 7i)));
}
let _e606 = phi_734_;
let _e607 = (_e606 * 6i);
let _e609 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e611 = select(_e609, _e607, (_e607 < _e609));
let _e617 = global_4.member[bitcast<u32>(select(0i, _e611, (_e611 > 0i)))];
let _e618 = bitcast<i32>(_e617);
let _e619 = (_e607 + 1i);
let _e621 = select(_e609, _e619, (_e619 < _e609));
let _e627 = global_4.member[bitcast<u32>(select(0i, _e621, (_e621 > 0i)))];
let _e632 = f32(_e618);
let _e634 = (_e607 + 2i);
let _e636 = select(_e609, _e634, (_e634 < _e609));
let _e642 = global_4.member[bitcast<u32>(select(0i, _e636, (_e636 > 0i)))];
let _e643 = bitcast<i32>(_e642);
let _e644 = (_e607 + 3i);
let _e646 = select(_e609, _e644, (_e644 < _e609));
let _e652 = global_4.member[bitcast<u32>(select(0i, _e646, (_e646 > 0i)))];
let _e662 = (((_e63.member_2 == 3u) || (_e63.member_2 == 4u)) || _e120);
if _e662 {
phi_860_ = vec3(_e632);
} else {
let _e663 = (_e607 + 4i);
let _e665 = select(_e609, _e663, (_e663 < _e609));
let _e671 = global_4.member[bitcast<u32>(select(0i, _e665, (_e665 > 0i)))];
phi_860_ = vec3<f32>(_e632, f32((bitcast<i32>(_e627) - (_e618 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e671)));
}
let _e677 = phi_860_;
let _e679 = select(0f, 1f, (_e606 >= 0i));
let _e684 = (firstTrailingBit(4u) & 31u);
let _e686 = (_e115 >> bitcast<u32>(_e684));
let _e688 = (_e118 >> bitcast<u32>(_e684));
let _e693 = (1f / 4f);
let _e694 = (f32((_e115 - (_e686 << bitcast<u32>(_e684)))) * _e693);
let _e699 = (f32((_e118 - (_e688 << bitcast<u32>(_e684)))) * _e693);
let _e704 = global_2.member.member_12.member_17.member;
let _e705 = bitcast<i32>(_e704);
let _e710 = global_2.member.member_12.member_17.member_1;
let _e711 = bitcast<i32>(_e710);
let _e712 = (_e686 + 1i);
let _e713 = (_e688 + 1i);
let _e716 = ((_e712 >= 0i) && (_e712 < _e705));
let _e717 = (_e713 >= 0i);
let _e719 = (_e713 < _e711);
if ((_e716 && _e717) && _e719) {
phi_915_ = ((_e713 * _e705) + _e712);
} else {
phi_915_ = -1i;
}
let _e724 = phi_915_;
let _e725 = (1f - _e694);
let _e726 = (1f - _e699);
let _e728 = (_e724 * 6i);
let _e730 = select(_e609, _e728, (_e728 < _e609));
let _e736 = global_4.member[bitcast<u32>(select(0i, _e730, (_e730 > 0i)))];
let _e737 = bitcast<i32>(_e736);
let _e738 = (_e728 + 1i);
let _e740 = select(_e609, _e738, (_e738 < _e609));
let _e746 = global_4.member[bitcast<u32>(select(0i, _e740, (_e740 > 0i)))];
let _e751 = f32(_e737);
let _e753 = (_e728 + 2i);
let _e755 = select(_e609, _e753, (_e753 < _e609));
let _e761 = global_4.member[bitcast<u32>(select(0i, _e755, (_e755 > 0i)))];
let _e762 = bitcast<i32>(_e761);
let _e763 = (_e728 + 3i);
let _e765 = select(_e609, _e763, (_e763 < _e609));
let _e771 = global_4.member[bitcast<u32>(select(0i, _e765, (_e765 > 0i)))];
if _e662 {
phi_1044_ = vec3(_e751);
} else {
let _e778 = (_e728 + 4i);
let _e780 = select(_e609, _e778, (_e778 < _e609));
let _e786 = global_4.member[bitcast<u32>(select(0i, _e780, (_e780 > 0i)))];
phi_1044_ = vec3<f32>(_e751, f32((bitcast<i32>(_e746) - (_e737 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e786)));
}
let _e792 = phi_1044_;
let _e794 = select(0f, (_e725 * _e726), (_e724 >= 0i));
let _e798 = (_e686 + 2i);
let _e801 = ((_e798 >= 0i) && (_e798 < _e705));
if ((_e801 && _e717) && _e719) {
phi_1079_ = ((_e713 * _e705) + _e798);
} else {
phi_1079_ = -1i;
}
let _e807 = phi_1079_;
let _e809 = (_e807 * 6i);
let _e811 = select(_e609, _e809, (_e809 < _e609));
let _e817 = global_4.member[bitcast<u32>(select(0i, _e811, (_e811 > 0i)))];
let _e818 = bitcast<i32>(_e817);
let _e819 = (_e809 + 1i);
let _e821 = select(_e609, _e819, (_e819 < _e609));
let _e827 = global_4.member[bitcast<u32>(select(0i, _e821, (_e821 > 0i)))];
let _e832 = f32(_e818);
let _e834 = (_e809 + 2i);
let _e836 = select(_e609, _e834, (_e834 < _e609));
let _e842 = global_4.member[bitcast<u32>(select(0i, _e836, (_e836 > 0i)))];
let _e843 = bitcast<i32>(_e842);
let _e844 = (_e809 + 3i);
let _e846 = select(_e609, _e844, (_e844 < _e609));
let _e852 = global_4.member[bitcast<u32>(select(0i, _e846, (_e846 > 0i)))];
if _e662 {
phi_1207_ = vec3(_e832);
} else {
let _e859 = (_e809 + 4i);
let _e861 = select(_e609, _e859, (_e859 < _e609));
let _e867 = global_4.member[bitcast<u32>(select(0i, _e861, (_e861 > 0i)))];
phi_1207_ = vec3<f32>(_e832, f32((bitcast<i32>(_e827) - (_e818 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e867)));
}
let _e873 = phi_1207_;
let _e875 = select(0f, (_e694 * _e726), (_e807 >= 0i));
let _e882 = (_e688 + 2i);
let _e883 = (_e882 >= 0i);
let _e885 = (_e882 < _e711);
if ((_e716 && _e883) && _e885) {
phi_1254_ = ((_e882 * _e705) + _e712);
} else {
phi_1254_ = -1i;
}
let _e890 = phi_1254_;
let _e892 = (_e890 * 6i);
let _e894 = select(_e609, _e892, (_e892 < _e609));
let _e900 = global_4.member[bitcast<u32>(select(0i, _e894, (_e894 > 0i)))];
let _e901 = bitcast<i32>(_e900);
let _e902 = (_e892 + 1i);
let _e904 = select(_e609, _e902, (_e902 < _e609));
let _e910 = global_4.member[bitcast<u32>(select(0i, _e904, (_e904 > 0i)))];
let _e915 = f32(_e901);
let _e917 = (_e892 + 2i);
let _e919 = select(_e609, _e917, (_e917 < _e609));
let _e925 = global_4.member[bitcast<u32>(select(0i, _e919, (_e919 > 0i)))];
let _e926 = bitcast<i32>(_e925);
let _e927 = (_e892 + 3i);
let _e929 = select(_e609, _e927, (_e927 < _e609));
let _e935 = global_4.member[bitcast<u32>(select(0i, _e929, (_e929 > 0i)))];
if _e662 {
phi_1382_ = vec3(_e915);
} else {
let _e942 = (_e892 + 4i);
let _e944 = select(_e609, _e942, (_e942 < _e609));
let _e950 = global_4.member[bitcast<u32>(select(0i, _e944, (_e944 > 0i)))];
phi_1382_ = vec3<f32>(_e915, f32((bitcast<i32>(_e910) - (_e901 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e950)));
}
let _e956 = phi_1382_;
let _e958 = select(0f, (_e725 * _e699), (_e890 >= 0i));
if ((_e801 && _e883) && _e885) {
phi_1418_ = ((_e882 * _e705) + _e798);
} else {
phi_1418_ = -1i;
}
let _e967 = phi_1418_;
let _e969 = (_e967 * 6i);
let _e971 = select(_e609, _e969, (_e969 < _e609));
let _e977 = global_4.member[bitcast<u32>(select(0i, _e971, (_e971 > 0i)))];
let _e978 = bitcast<i32>(_e977);
let _e979 = (_e969 + 1i);
let _e981 = select(_e609, _e979, (_e979 < _e609));
let _e987 = global_4.member[bitcast<u32>(select(0i, _e981, (_e981 > 0i)))];
let _e992 = f32(_e978);
let _e994 = (_e969 + 2i);
let _e996 = select(_e609, _e994, (_e994 < _e609));
let _e1002 = global_4.member[bitcast<u32>(select(0i, _e996, (_e996 > 0i)))];
let _e1003 = bitcast<i32>(_e1002);
let _e1004 = (_e969 + 3i);
let _e1006 = select(_e609, _e1004, (_e1004 < _e609));
let _e1012 = global_4.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
if _e662 {
phi_1545_ = vec3(_e992);
} else {
let _e1019 = (_e969 + 4i);
let _e1021 = select(_e609, _e1019, (_e1019 < _e609));
let _e1027 = global_4.member[bitcast<u32>(select(0i, _e1021, (_e1021 > 0i)))];
phi_1545_ = vec3<f32>(_e992, f32((bitcast<i32>(_e987) - (_e978 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e1027)));
}
let _e1033 = phi_1545_;
let _e1035 = select(0f, (_e694 * _e699), (_e967 >= 0i));
let _e1045 = ((_e677 * _e679) + (((_e792 * _e794) + (_e873 * _e875)) + ((_e956 * _e958) + (_e1033 * _e1035))));
let _e1051 = global_2.member.member_12.member_22;
let _e1052 = (1f / _e1051);
let _e1059 = ((select(1f, (_e268 * _e258), _e240) * _e521) + (_e1045.x * _e1052));
let _e1060 = ((select(1f, (_e278 * _e258), _e240) * _e521) + (_e1045.y * _e1052));
let _e1061 = ((select(1f, (_e288 * _e258), _e240) * _e521) + (_e1045.z * _e1052));
let _e1065 = (((_e1059 + _e1060) + _e1061) * (1f / 3f));
let _e1066 = (_e1065 > 1e-4f);
let _e1069 = select(0f, (1f / select(1e-4f, _e1065, _e1066)), _e1066);
let _e1072 = (((_e298 * _e258) + (((f32(_e643) * _e679) + (((f32(_e762) * _e794) + (f32(_e843) * _e875)) + ((f32(_e926) * _e958) + (f32(_e1003) * _e1035)))) * _e1052)) * _e1069);
let _e1075 = (((_e308 * _e258) + (((f32((bitcast<i32>(_e652) - (_e643 >> bitcast<u32>(31i)))) * _e679) + (((f32((bitcast<i32>(_e771) - (_e762 >> bitcast<u32>(31i)))) * _e794) + (f32((bitcast<i32>(_e852) - (_e843 >> bitcast<u32>(31i)))) * _e875)) + ((f32((bitcast<i32>(_e935) - (_e926 >> bitcast<u32>(31i)))) * _e958) + (f32((bitcast<i32>(_e1012) - (_e1003 >> bitcast<u32>(31i)))) * _e1035)))) * _e1052)) * _e1069);
let _e1076 = (1f / _e445);
if (_e1072 < 0f) {
let _e1108 = ((bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u)) * 16255f) + 0.5f);
let _e1109 = (2f * 16255f);
let _e1111 = select(0f, _e1108, (_e1108 > 0f));
let _e1113 = select(_e1109, _e1111, (_e1111 < _e1109));
let _e1120 = select(0i, select(select(i32(_e1113), i32(-2147483648), (_e1113 < -2147483600f)), 2147483647i, (_e1113 > 2147483500f)), (_e1113 == _e1113));
phi_1643_ = (32768i - (_e1120 - select(0i, 1i, (_e1113 < f32(_e1120)))));
} else {
let _e1086 = ((bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u)) * 16255f) + 0.5f);
let _e1087 = (2f * 16255f);
let _e1089 = select(0f, _e1086, (_e1086 > 0f));
let _e1091 = select(_e1087, _e1089, (_e1089 < _e1087));
let _e1098 = select(0i, select(select(i32(_e1091), i32(-2147483648), (_e1091 < -2147483600f)), 2147483647i, (_e1091 > 2147483500f)), (_e1091 == _e1091));
phi_1643_ = (32768i + (_e1098 - select(0i, 1i, (_e1091 < f32(_e1098)))));
}
let _e1127 = phi_1643_;
let _e1132 = ((bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u)) * 16255f) + 0.5f);
let _e1133 = (2f * 16255f);
let _e1135 = select(0f, _e1132, (_e1132 > 0f));
let _e1137 = select(_e1133, _e1135, (_e1135 < _e1133));
let _e1144 = select(0i, select(select(i32(_e1137), i32(-2147483648), (_e1137 < -2147483600f)), 2147483647i, (_e1137 > 2147483500f)), (_e1137 == _e1137));
let _e1148 = (_e1144 - select(0i, 1i, (_e1137 < f32(_e1144))));
phi_1794_ = type_21(vec3<f32>((_e1059 * _e1076), (_e1060 * _e1076), (_e1061 * _e1076)), bitcast<f32>(((select(0u, 2147483648u, ((_e1075 < 0f) && (_e1148 > 0i))) | (bitcast<u32>((_e1148 + 128i)) << bitcast<u32>(16i))) | bitcast<u32>(_e1127))));
} else {
let _e133 = global_2.member.member_12.member_4.member;
let _e143 = global_2.member.member_12.member_4.member_1;
let _e146 = ((((_e115 >= 0i) && (_e115 <= bitcast<i32>(_e133))) && (_e118 >= 0i)) && (_e118 <= bitcast<i32>(_e143)));
if _e146 {
phi_1683_ = bitcast<u32>(_e118);
phi_1684_ = bitcast<u32>(_e115);
} else {
phi_1683_ = 0u;
phi_1684_ = 0u;
}
let _e150 = phi_1683_;
let _e152 = phi_1684_;
let _e153 = (_e133 + 1u);
let _e156 = bitcast<i32>((_e153 * (_e143 + 1u)));
let _e161 = ((6i * _e156) + bitcast<i32>(((_e150 * _e153) + _e152)));
let _e163 = (bitcast<i32>(_e55) - 1i);
let _e165 = select(_e163, _e161, (_e161 < _e163));
let _e171 = global_3.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e172 = (_e161 + _e156);
let _e174 = select(_e163, _e172, (_e172 < _e163));
let _e180 = global_3.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = (_e161 + (2i * _e156));
let _e184 = select(_e163, _e182, (_e182 < _e163));
let _e190 = global_3.member[bitcast<u32>(select(0i, _e184, (_e184 > 0i)))];
let _e196 = ((0f * 16255f) + 0.5f);
let _e197 = (2f * 16255f);
let _e199 = select(0f, _e196, (_e196 > 0f));
let _e201 = select(_e197, _e199, (_e199 < _e197));
let _e208 = select(0i, select(select(i32(_e201), i32(-2147483648), (_e201 < -2147483600f)), 2147483647i, (_e201 > 2147483500f)), (_e201 == _e201));
let _e212 = (_e208 - select(0i, 1i, (_e201 < f32(_e208))));
phi_1794_ = type_21(vec3<f32>(select(1f, _e171, _e146), select(1f, _e180, _e146), select(1f, _e190, _e146)), bitcast<f32>(((bitcast<u32>((_e212 + 128i)) << bitcast<u32>(16i)) | bitcast<u32>((32768i + _e212)))));
}
let _e1163 = phi_1794_;
global_1.member[_e78] = _e1163.member.x;
global_1.member[((_e63.member * _e63.member_1) + _e78)] = _e1163.member_1;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
