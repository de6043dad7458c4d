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
struct type_17 {
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
struct type_18 {
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
struct type_19 {
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
struct type_20 {
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
struct type_21 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_22 {
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
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_20,
member_19: type_21,
}
struct type_23 {
member: type_22,
}
struct type_26 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(2)
var<storage> global_3: type_15;
@group(0) @binding(3)
var<storage, read_write> global_4: type_26;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var phi_1007_: i32;
var phi_1010_: f32;
var phi_1148_: i32;
var phi_1161_: i32;
var phi_1175_: i32;
var phi_1491_: i32;
var phi_1504_: i32;
var phi_1518_: i32;
var phi_1721_: f32;
var phi_2092_: u32;
var phi_2167_: u32;
var phi_2242_: u32;
var phi_2317_: u32;
var phi_2392_: u32;
var phi_2467_: u32;
var phi_1008_: i32;
var phi_1011_: f32;
let _e65 = global;
let _e73 = arrayLength((&global_4.member));
let _e76 = global_1.member.member;
if (_e65.x < _e76.member) {
if (_e65.y < _e76.member_1) {
let _e83 = bitcast<i32>(_e65.x);
let _e87 = global_1.member.member.member;
let _e88 = bitcast<i32>(_e87);
let _e92 = global_1.member.member_12.member_4;
let _e96 = global_1.member.member_12.member_6;
let _e98 = bitcast<i32>((_e92 * _e96));
local_7 = _e98;
local_8 = _e83;
local_9 = _e88;
let _e99 = local_7;
let _e100 = local_9;
let _e103 = local_8;
let _e104 = ((_e99 + (18i * _e100)) + _e103);
let _e106 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e108 = select(_e106, _e104, (_e104 < _e106));
let _e113 = global_2.member[bitcast<u32>(select(0i, _e108, (_e108 > 0i)))];
let _e114 = local_7;
let _e115 = local_9;
let _e118 = local_8;
let _e119 = ((_e114 + (19i * _e115)) + _e118);
let _e121 = select(_e106, _e119, (_e119 < _e106));
let _e126 = global_2.member[bitcast<u32>(select(0i, _e121, (_e121 > 0i)))];
let _e128 = local_7;
let _e129 = local_9;
let _e132 = local_8;
let _e133 = ((_e128 + (20i * _e129)) + _e132);
let _e135 = select(_e106, _e133, (_e133 < _e106));
let _e140 = global_2.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
if (((_e113 + _e126) + _e140) > 0f) {
local_4 = _e98;
local_5 = _e83;
local_6 = _e88;
let _e143 = local_4;
let _e144 = local_5;
let _e145 = (_e143 + _e144);
let _e147 = select(_e106, _e145, (_e145 < _e106));
let _e152 = global_2.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e153 = local_4;
let _e154 = local_6;
let _e156 = local_5;
let _e157 = ((_e153 + _e154) + _e156);
let _e159 = select(_e106, _e157, (_e157 < _e106));
let _e164 = global_2.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e165 = local_4;
let _e166 = local_6;
let _e169 = local_5;
let _e170 = ((_e165 + (2i * _e166)) + _e169);
let _e172 = select(_e106, _e170, (_e170 < _e106));
let _e177 = global_2.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e178 = local_4;
let _e179 = local_6;
let _e182 = local_5;
let _e183 = ((_e178 + (3i * _e179)) + _e182);
let _e185 = select(_e106, _e183, (_e183 < _e106));
let _e190 = global_2.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e191 = local_4;
let _e192 = local_6;
let _e195 = local_5;
let _e196 = ((_e191 + (4i * _e192)) + _e195);
let _e198 = select(_e106, _e196, (_e196 < _e106));
let _e203 = global_2.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e204 = local_4;
let _e205 = local_6;
let _e208 = local_5;
let _e209 = ((_e204 + (5i * _e205)) + _e208);
let _e211 = select(_e106, _e209, (_e209 < _e106));
let _e216 = global_2.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e217 = local_4;
let _e218 = local_6;
let _e221 = local_5;
let _e222 = ((_e217 + (18i * _e218)) + _e221);
let _e224 = select(_e106, _e222, (_e222 < _e106));
let _e229 = global_2.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e230 = local_4;
let _e231 = local_6;
let _e234 = local_5;
let _e235 = ((_e230 + (19i * _e231)) + _e234);
let _e237 = select(_e106, _e235, (_e235 < _e106));
let _e242 = global_2.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e243 = local_4;
let _e244 = local_6;
let _e247 = local_5;
let _e248 = ((_e243 + (20i * _e244)) + _e247);
let _e250 = select(_e106, _e248, (_e248 < _e106));
let _e255 = global_2.member[bitcast<u32>(select(0i, _e250, (_e250 > 0i)))];
let _e256 = local_4;
let _e257 = local_6;
let _e260 = local_5;
let _e261 = ((_e256 + (23i * _e257)) + _e260);
let _e263 = select(_e106, _e261, (_e261 < _e106));
let _e268 = global_2.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e273 = global_1.member.member_19.member.member;
let _e278 = global_1.member.member_19.member.member_1;
let _e283 = global_1.member.member_19.member.member_2;
let _e286 = select(_e278, _e273, (_e273 < _e278));
let _e289 = ((2f * _e268) / select(_e283, _e286, (_e286 < _e283)));
let _e290 = (64f - 1f);
let _e292 = select(0f, _e289, (_e289 > 0f));
let _e294 = select(_e290, _e292, (_e292 < _e290));
let _e301 = select(0i, select(select(i32(_e294), i32(-2147483648), (_e294 < -2147483600f)), 2147483647i, (_e294 > 2147483500f)), (_e294 == _e294));
let _e306 = ((_e301 - select(0i, 1i, (_e294 < f32(_e301)))) + 1i);
let _e308 = (_e268 / f32(_e306));
let _e313 = global_1.member.member_19.member_1;
phi_1007_ = 0i;
phi_1010_ = 0f;
loop {
let _e317 = phi_1007_;
let _e319 = phi_1010_;
let _e320 = (_e317 < _e306);
if _e320 {
let _e322 = (f32(_e317) * _e308);
let _e326 = global_1.member.member_13.member_6;
if (_e326 == 0u) {
phi_1721_ = _e308;
} else {
let _e328 = (_e322 + _e308);
let _e330 = (0.5f * (_e322 + _e328));
let _e331 = (_e328 - _e322);
let _e332 = (0.28867513f * _e331);
let _e333 = (_e330 - _e332);
let _e343 = global_1.member.member_13.member_7;
let _e344 = bitcast<i32>(_e343);
let _e348 = global_1.member.member_13.member_8;
let _e349 = bitcast<i32>(_e348);
let _e353 = global_1.member.member_13.member_9;
let _e354 = bitcast<i32>(_e353);
let _e358 = global_1.member.member_13.member_4;
let _e365 = global_1.member.member_13.member_5;
let _e369 = f32(_e344);
let _e371 = (_e365.member - _e358.member);
let _e374 = (((((_e152 + (_e190 * _e333)) - _e358.member) / _e371) * _e369) - 0.5f);
let _e375 = (_e369 - 1f);
let _e377 = select(0f, _e374, (_e374 > 0f));
let _e379 = select(_e375, _e377, (_e377 < _e375));
let _e380 = f32(_e349);
let _e382 = (_e365.member_1 - _e358.member_1);
let _e385 = (((((_e164 + (_e203 * _e333)) - _e358.member_1) / _e382) * _e380) - 0.5f);
let _e386 = (_e380 - 1f);
let _e388 = select(0f, _e385, (_e385 > 0f));
let _e390 = select(_e386, _e388, (_e388 < _e386));
let _e391 = f32(_e354);
let _e393 = (_e365.member_2 - _e358.member_2);
let _e396 = (((((_e177 + (_e216 * _e333)) - _e358.member_2) / _e393) * _e391) - 0.5f);
let _e397 = (_e391 - 1f);
let _e399 = select(0f, _e396, (_e396 > 0f));
let _e401 = select(_e397, _e399, (_e399 < _e397));
let _e403 = select(0f, _e379, (_e379 > 0f));
let _e405 = select(1e6f, _e403, (_e403 < 1e6f));
let _e412 = select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < -2147483600f)), 2147483647i, (_e405 > 2147483500f)), (_e405 == _e405));
let _e416 = (_e412 - select(0i, 1i, (_e405 < f32(_e412))));
let _e418 = select(0f, _e390, (_e390 > 0f));
let _e420 = select(1e6f, _e418, (_e418 < 1e6f));
let _e427 = select(0i, select(select(i32(_e420), i32(-2147483648), (_e420 < -2147483600f)), 2147483647i, (_e420 > 2147483500f)), (_e420 == _e420));
let _e431 = (_e427 - select(0i, 1i, (_e420 < f32(_e427))));
let _e433 = select(0f, _e401, (_e401 > 0f));
let _e435 = select(1e6f, _e433, (_e433 < 1e6f));
let _e442 = select(0i, select(select(i32(_e435), i32(-2147483648), (_e435 < -2147483600f)), 2147483647i, (_e435 > 2147483500f)), (_e435 == _e435));
let _e446 = (_e442 - select(0i, 1i, (_e435 < f32(_e442))));
let _e450 = (_e390 - f32(_e431));
let _e452 = (_e401 - f32(_e446));
local_2 = (_e379 - f32(_e416));
let _e453 = (_e416 + 1i);
let _e455 = select(_e453, 0i, (_e453 < 0i));
if (_e455 >= _e344) {
phi_1148_ = (_e344 - 1i);
} else {
phi_1148_ = _e455;
}
let _e459 = phi_1148_;
local_3 = (_e459 - _e416);
let _e461 = (_e431 + 1i);
let _e463 = select(_e461, 0i, (_e461 < 0i));
if (_e463 >= _e349) {
phi_1161_ = (_e349 - 1i);
} else {
phi_1161_ = _e463;
}
let _e467 = phi_1161_;
let _e469 = ((_e467 - _e431) * _e344);
let _e470 = (_e446 + 1i);
let _e472 = select(_e470, 0i, (_e470 < 0i));
if (_e472 >= _e354) {
phi_1175_ = (_e354 - 1i);
} else {
phi_1175_ = _e472;
}
let _e476 = phi_1175_;
let _e483 = global_1.member.member_13.member_10;
let _e484 = bitcast<i32>(_e483);
let _e489 = ((_e484 + (((_e446 * _e349) + _e431) * _e344)) + _e416);
let _e491 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e493 = select(_e491, _e489, (_e489 < _e491));
let _e498 = global_3.member[bitcast<u32>(select(0i, _e493, (_e493 > 0i)))];
let _e499 = local_2;
let _e502 = local_3;
let _e503 = (_e489 + _e502);
let _e505 = select(_e491, _e503, (_e503 < _e491));
let _e510 = global_3.member[bitcast<u32>(select(0i, _e505, (_e505 > 0i)))];
let _e511 = local_2;
let _e514 = (1f - _e450);
let _e516 = (_e489 + _e469);
let _e518 = select(_e491, _e516, (_e516 < _e491));
let _e523 = global_3.member[bitcast<u32>(select(0i, _e518, (_e518 > 0i)))];
let _e524 = local_2;
let _e527 = local_3;
let _e528 = (_e516 + _e527);
let _e530 = select(_e491, _e528, (_e528 < _e491));
let _e535 = global_3.member[bitcast<u32>(select(0i, _e530, (_e530 > 0i)))];
let _e536 = local_2;
let _e541 = (_e489 + (((_e476 - _e446) * _e344) * _e349));
let _e543 = select(_e491, _e541, (_e541 < _e491));
let _e548 = global_3.member[bitcast<u32>(select(0i, _e543, (_e543 > 0i)))];
let _e549 = local_2;
let _e552 = local_3;
let _e553 = (_e541 + _e552);
let _e555 = select(_e491, _e553, (_e553 < _e491));
let _e560 = global_3.member[bitcast<u32>(select(0i, _e555, (_e555 > 0i)))];
let _e561 = local_2;
let _e565 = (_e541 + _e469);
let _e567 = select(_e491, _e565, (_e565 < _e491));
let _e572 = global_3.member[bitcast<u32>(select(0i, _e567, (_e567 > 0i)))];
let _e573 = local_2;
let _e576 = local_3;
let _e577 = (_e565 + _e576);
let _e579 = select(_e491, _e577, (_e577 < _e491));
let _e584 = global_3.member[bitcast<u32>(select(0i, _e579, (_e579 > 0i)))];
let _e585 = local_2;
let _e594 = (_e330 + _e332);
let _e604 = (((((_e152 + (_e190 * _e594)) - _e358.member) / _e371) * _e369) - 0.5f);
let _e606 = select(0f, _e604, (_e604 > 0f));
let _e608 = select(_e375, _e606, (_e606 < _e375));
let _e612 = (((((_e164 + (_e203 * _e594)) - _e358.member_1) / _e382) * _e380) - 0.5f);
let _e614 = select(0f, _e612, (_e612 > 0f));
let _e616 = select(_e386, _e614, (_e614 < _e386));
let _e620 = (((((_e177 + (_e216 * _e594)) - _e358.member_2) / _e393) * _e391) - 0.5f);
let _e622 = select(0f, _e620, (_e620 > 0f));
let _e624 = select(_e397, _e622, (_e622 < _e397));
let _e626 = select(0f, _e608, (_e608 > 0f));
let _e628 = select(1e6f, _e626, (_e626 < 1e6f));
let _e635 = select(0i, select(select(i32(_e628), i32(-2147483648), (_e628 < -2147483600f)), 2147483647i, (_e628 > 2147483500f)), (_e628 == _e628));
let _e639 = (_e635 - select(0i, 1i, (_e628 < f32(_e635))));
let _e641 = select(0f, _e616, (_e616 > 0f));
let _e643 = select(1e6f, _e641, (_e641 < 1e6f));
let _e650 = select(0i, select(select(i32(_e643), i32(-2147483648), (_e643 < -2147483600f)), 2147483647i, (_e643 > 2147483500f)), (_e643 == _e643));
let _e654 = (_e650 - select(0i, 1i, (_e643 < f32(_e650))));
let _e656 = select(0f, _e624, (_e624 > 0f));
let _e658 = select(1e6f, _e656, (_e656 < 1e6f));
let _e665 = select(0i, select(select(i32(_e658), i32(-2147483648), (_e658 < -2147483600f)), 2147483647i, (_e658 > 2147483500f)), (_e658 == _e658));
let _e669 = (_e665 - select(0i, 1i, (_e658 < f32(_e665))));
let _e673 = (_e616 - f32(_e654));
let _e675 = (_e624 - f32(_e669));
local = (_e608 - f32(_e639));
let _e676 = (_e639 + 1i);
let _e678 = select(_e676, 0i, (_e676 < 0i));
if (_e678 >= _e344) {
phi_1491_ = (_e344 - 1i);
} else {
phi_1491_ = _e678;
}
let _e682 = phi_1491_;
local_1 = (_e682 - _e639);
let _e684 = (_e654 + 1i);
let _e686 = select(_e684, 0i, (_e684 < 0i));
if (_e686 >= _e349) {
phi_1504_ = (_e349 - 1i);
} else {
phi_1504_ = _e686;
}
let _e690 = phi_1504_;
let _e692 = ((_e690 - _e654) * _e344);
let _e693 = (_e669 + 1i);
let _e695 = select(_e693, 0i, (_e693 < 0i));
if (_e695 >= _e354) {
phi_1518_ = (_e354 - 1i);
} else {
phi_1518_ = _e695;
}
let _e699 = phi_1518_;
let _e707 = ((_e484 + (((_e669 * _e349) + _e654) * _e344)) + _e639);
let _e709 = select(_e491, _e707, (_e707 < _e491));
let _e714 = global_3.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e715 = local;
let _e718 = local_1;
let _e719 = (_e707 + _e718);
let _e721 = select(_e491, _e719, (_e719 < _e491));
let _e726 = global_3.member[bitcast<u32>(select(0i, _e721, (_e721 > 0i)))];
let _e727 = local;
let _e730 = (1f - _e673);
let _e732 = (_e707 + _e692);
let _e734 = select(_e491, _e732, (_e732 < _e491));
let _e739 = global_3.member[bitcast<u32>(select(0i, _e734, (_e734 > 0i)))];
let _e740 = local;
let _e743 = local_1;
let _e744 = (_e732 + _e743);
let _e746 = select(_e491, _e744, (_e744 < _e491));
let _e751 = global_3.member[bitcast<u32>(select(0i, _e746, (_e746 > 0i)))];
let _e752 = local;
let _e757 = (_e707 + (((_e699 - _e669) * _e344) * _e349));
let _e759 = select(_e491, _e757, (_e757 < _e491));
let _e764 = global_3.member[bitcast<u32>(select(0i, _e759, (_e759 > 0i)))];
let _e765 = local;
let _e768 = local_1;
let _e769 = (_e757 + _e768);
let _e771 = select(_e491, _e769, (_e769 < _e491));
let _e776 = global_3.member[bitcast<u32>(select(0i, _e771, (_e771 > 0i)))];
let _e777 = local;
let _e781 = (_e757 + _e692);
let _e783 = select(_e491, _e781, (_e781 < _e491));
let _e788 = global_3.member[bitcast<u32>(select(0i, _e783, (_e783 > 0i)))];
let _e789 = local;
let _e792 = local_1;
let _e793 = (_e781 + _e792);
let _e795 = select(_e491, _e793, (_e793 < _e491));
let _e800 = global_3.member[bitcast<u32>(select(0i, _e795, (_e795 > 0i)))];
let _e801 = local;
phi_1721_ = ((0.5f * (((((((_e498 * (1f - _e499)) + (_e510 * _e511)) * _e514) + (((_e523 * (1f - _e524)) + (_e535 * _e536)) * _e450)) * (1f - _e452)) + (((((_e548 * (1f - _e549)) + (_e560 * _e561)) * _e514) + (((_e572 * (1f - _e573)) + (_e584 * _e585)) * _e450)) * _e452)) + ((((((_e714 * (1f - _e715)) + (_e726 * _e727)) * _e730) + (((_e739 * (1f - _e740)) + (_e751 * _e752)) * _e673)) * (1f - _e675)) + (((((_e764 * (1f - _e765)) + (_e776 * _e777)) * _e730) + (((_e788 * (1f - _e789)) + (_e800 * _e801)) * _e673)) * _e675)))) * _e331);
}
let _e814 = phi_1721_;
let _e816 = (_e319 + (0.5f * _e814));
let _e820 = global_1.member.member_13.member;
let _e825 = -((_e820.member * _e816));
let _e827 = select(-87f, _e825, (_e825 > -87f));
let _e829 = select(88f, _e827, (_e827 < 88f));
let _e831 = ((_e829 * 1.442695f) + 0.5f);
let _e833 = select(-127f, _e831, (_e831 > -127f));
let _e835 = select(128f, _e833, (_e833 < 128f));
let _e842 = select(0i, select(select(i32(_e835), i32(-2147483648), (_e835 < -2147483600f)), 2147483647i, (_e835 > 2147483500f)), (_e835 == _e835));
let _e846 = (_e842 - select(0i, 1i, (_e835 < f32(_e842))));
let _e847 = f32(_e846);
let _e851 = ((_e829 - (_e847 * 0.6933594f)) - (_e847 * -2.1219444e-4f));
let _e873 = -((_e820.member_1 * _e816));
let _e875 = select(-87f, _e873, (_e873 > -87f));
let _e877 = select(88f, _e875, (_e875 < 88f));
let _e879 = ((_e877 * 1.442695f) + 0.5f);
let _e881 = select(-127f, _e879, (_e879 > -127f));
let _e883 = select(128f, _e881, (_e881 < 128f));
let _e890 = select(0i, select(select(i32(_e883), i32(-2147483648), (_e883 < -2147483600f)), 2147483647i, (_e883 > 2147483500f)), (_e883 == _e883));
let _e894 = (_e890 - select(0i, 1i, (_e883 < f32(_e890))));
let _e895 = f32(_e894);
let _e899 = ((_e877 - (_e895 * 0.6933594f)) - (_e895 * -2.1219444e-4f));
let _e921 = -((_e820.member_2 * _e816));
let _e923 = select(-87f, _e921, (_e921 > -87f));
let _e925 = select(88f, _e923, (_e923 < 88f));
let _e927 = ((_e925 * 1.442695f) + 0.5f);
let _e929 = select(-127f, _e927, (_e927 > -127f));
let _e931 = select(128f, _e929, (_e929 < 128f));
let _e938 = select(0i, select(select(i32(_e931), i32(-2147483648), (_e931 < -2147483600f)), 2147483647i, (_e931 > 2147483500f)), (_e931 == _e931));
let _e942 = (_e938 - select(0i, 1i, (_e931 < f32(_e938))));
let _e943 = f32(_e942);
let _e947 = ((_e925 - (_e943 * 0.6933594f)) - (_e943 * -2.1219444e-4f));
let _e971 = (_e308 * select(_e313, -(_e313), (_e92 == 0u)));
let _e972 = ((_e229 * ((1f + (_e851 * (1f + (_e851 * (0.5f + (_e851 * (0.16666667f + (_e851 * (0.041666668f + (_e851 * (0.008333334f + (_e851 * (0.001388889f + (_e851 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e846 + 127i)) << bitcast<u32>(23i))))) * _e971);
let _e973 = ((_e242 * ((1f + (_e899 * (1f + (_e899 * (0.5f + (_e899 * (0.16666667f + (_e899 * (0.041666668f + (_e899 * (0.008333334f + (_e899 * (0.001388889f + (_e899 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e894 + 127i)) << bitcast<u32>(23i))))) * _e971);
let _e974 = ((_e255 * ((1f + (_e947 * (1f + (_e947 * (0.5f + (_e947 * (0.16666667f + (_e947 * (0.041666668f + (_e947 * (0.008333334f + (_e947 * (0.001388889f + (_e947 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e942 + 127i)) << bitcast<u32>(23i))))) * _e971);
let _e978 = (((_e972 + _e973) + _e974) * (1f / 3f));
let _e979 = (_e190 * _e978);
let _e980 = (_e203 * _e978);
let _e981 = (_e216 * _e978);
let _e983 = (_e322 + (0.5f * _e308));
let _e993 = global_1.member.member_13.member_4;
let _e1000 = global_1.member.member_19.member;
let _e1005 = (((_e152 + (_e190 * _e983)) - _e993.member) / _e1000.member);
let _e1007 = select(0f, _e1005, (_e1005 > 0f));
let _e1009 = select(15f, _e1007, (_e1007 < 15f));
let _e1016 = select(0i, select(select(i32(_e1009), i32(-2147483648), (_e1009 < -2147483600f)), 2147483647i, (_e1009 > 2147483500f)), (_e1009 == _e1009));
let _e1022 = (((_e164 + (_e203 * _e983)) - _e993.member_1) / _e1000.member_1);
let _e1024 = select(0f, _e1022, (_e1022 > 0f));
let _e1026 = select(15f, _e1024, (_e1024 < 15f));
let _e1033 = select(0i, select(select(i32(_e1026), i32(-2147483648), (_e1026 < -2147483600f)), 2147483647i, (_e1026 > 2147483500f)), (_e1026 == _e1026));
let _e1039 = (((_e177 + (_e216 * _e983)) - _e993.member_2) / _e1000.member_2);
let _e1041 = select(0f, _e1039, (_e1039 > 0f));
let _e1043 = select(15f, _e1041, (_e1041 < 15f));
let _e1050 = select(0i, select(select(i32(_e1043), i32(-2147483648), (_e1043 < -2147483600f)), 2147483647i, (_e1043 > 2147483500f)), (_e1043 == _e1043));
let _e1059 = ((((((_e1050 - select(0i, 1i, (_e1043 < f32(_e1050)))) * 16i) + (_e1033 - select(0i, 1i, (_e1026 < f32(_e1033))))) * 16i) + (_e1016 - select(0i, 1i, (_e1009 < f32(_e1016))))) * 12i);
let _e1063 = (bitcast<f32>((bitcast<u32>(_e972) & 2147483647u)) >= 1073741800f);
let _e1064 = (1f / 1048576f);
let _e1067 = ((_e972 * select(1f, _e1064, _e1063)) + 0.5f);
let _e1069 = select(-1073741800f, _e1067, (_e1067 > -1073741800f));
let _e1071 = select(1073741800f, _e1069, (_e1069 < 1073741800f));
let _e1078 = select(0i, select(select(i32(_e1071), i32(-2147483648), (_e1071 < -2147483600f)), 2147483647i, (_e1071 > 2147483500f)), (_e1071 == _e1071));
let _e1082 = (_e1078 - select(0i, 1i, (_e1071 < f32(_e1078))));
let _e1083 = select(0i, 20i, _e1063);
let _e1087 = (bitcast<u32>(_e1082) << bitcast<u32>((_e1083 & 31i)));
let _e1094 = bitcast<u32>(((_e1082 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1083) & 31i))));
if ((_e1087 | _e1094) == 0u) {
} else {
let _e1097 = bitcast<u32>(_e1059);
if (_e1097 < _e73) {
let _e1101 = atomicAdd((&global_4.member[_e1097]), _e1087);
phi_2092_ = _e1101;
} else {
phi_2092_ = 0u;
}
let _e1103 = phi_2092_;
let _e1107 = (_e1094 + select(0u, 1u, ((_e1103 + _e1087) < _e1087)));
if (_e1107 == 0u) {
} else {
let _e1109 = (_e1097 + 1u);
if (_e1109 < _e73) {
let _e1113 = atomicAdd((&global_4.member[_e1109]), _e1107);
}
}
}
let _e1117 = (bitcast<f32>((bitcast<u32>(_e973) & 2147483647u)) >= 1073741800f);
let _e1120 = ((_e973 * select(1f, _e1064, _e1117)) + 0.5f);
let _e1122 = select(-1073741800f, _e1120, (_e1120 > -1073741800f));
let _e1124 = select(1073741800f, _e1122, (_e1122 < 1073741800f));
let _e1131 = select(0i, select(select(i32(_e1124), i32(-2147483648), (_e1124 < -2147483600f)), 2147483647i, (_e1124 > 2147483500f)), (_e1124 == _e1124));
let _e1135 = (_e1131 - select(0i, 1i, (_e1124 < f32(_e1131))));
let _e1136 = select(0i, 20i, _e1117);
let _e1140 = (bitcast<u32>(_e1135) << bitcast<u32>((_e1136 & 31i)));
let _e1147 = bitcast<u32>(((_e1135 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1136) & 31i))));
if ((_e1140 | _e1147) == 0u) {
} else {
let _e1151 = bitcast<u32>((_e1059 + 2i));
if (_e1151 < _e73) {
let _e1155 = atomicAdd((&global_4.member[_e1151]), _e1140);
phi_2167_ = _e1155;
} else {
phi_2167_ = 0u;
}
let _e1157 = phi_2167_;
let _e1161 = (_e1147 + select(0u, 1u, ((_e1157 + _e1140) < _e1140)));
if (_e1161 == 0u) {
} else {
let _e1163 = (_e1151 + 1u);
if (_e1163 < _e73) {
let _e1167 = atomicAdd((&global_4.member[_e1163]), _e1161);
}
}
}
let _e1171 = (bitcast<f32>((bitcast<u32>(_e974) & 2147483647u)) >= 1073741800f);
let _e1174 = ((_e974 * select(1f, _e1064, _e1171)) + 0.5f);
let _e1176 = select(-1073741800f, _e1174, (_e1174 > -1073741800f));
let _e1178 = select(1073741800f, _e1176, (_e1176 < 1073741800f));
let _e1185 = select(0i, select(select(i32(_e1178), i32(-2147483648), (_e1178 < -2147483600f)), 2147483647i, (_e1178 > 2147483500f)), (_e1178 == _e1178));
let _e1189 = (_e1185 - select(0i, 1i, (_e1178 < f32(_e1185))));
let _e1190 = select(0i, 20i, _e1171);
let _e1194 = (bitcast<u32>(_e1189) << bitcast<u32>((_e1190 & 31i)));
let _e1201 = bitcast<u32>(((_e1189 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1190) & 31i))));
if ((_e1194 | _e1201) == 0u) {
} else {
let _e1205 = bitcast<u32>((_e1059 + 4i));
if (_e1205 < _e73) {
let _e1209 = atomicAdd((&global_4.member[_e1205]), _e1194);
phi_2242_ = _e1209;
} else {
phi_2242_ = 0u;
}
let _e1211 = phi_2242_;
let _e1215 = (_e1201 + select(0u, 1u, ((_e1211 + _e1194) < _e1194)));
if (_e1215 == 0u) {
} else {
let _e1217 = (_e1205 + 1u);
if (_e1217 < _e73) {
let _e1221 = atomicAdd((&global_4.member[_e1217]), _e1215);
}
}
}
let _e1225 = (bitcast<f32>((bitcast<u32>(_e979) & 2147483647u)) >= 1073741800f);
let _e1228 = ((_e979 * select(1f, _e1064, _e1225)) + 0.5f);
let _e1230 = select(-1073741800f, _e1228, (_e1228 > -1073741800f));
let _e1232 = select(1073741800f, _e1230, (_e1230 < 1073741800f));
let _e1239 = select(0i, select(select(i32(_e1232), i32(-2147483648), (_e1232 < -2147483600f)), 2147483647i, (_e1232 > 2147483500f)), (_e1232 == _e1232));
let _e1243 = (_e1239 - select(0i, 1i, (_e1232 < f32(_e1239))));
let _e1244 = select(0i, 20i, _e1225);
let _e1248 = (bitcast<u32>(_e1243) << bitcast<u32>((_e1244 & 31i)));
let _e1255 = bitcast<u32>(((_e1243 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1244) & 31i))));
if ((_e1248 | _e1255) == 0u) {
} else {
let _e1259 = bitcast<u32>((_e1059 + 6i));
if (_e1259 < _e73) {
let _e1263 = atomicAdd((&global_4.member[_e1259]), _e1248);
phi_2317_ = _e1263;
} else {
phi_2317_ = 0u;
}
let _e1265 = phi_2317_;
let _e1269 = (_e1255 + select(0u, 1u, ((_e1265 + _e1248) < _e1248)));
if (_e1269 == 0u) {
} else {
let _e1271 = (_e1259 + 1u);
if (_e1271 < _e73) {
let _e1275 = atomicAdd((&global_4.member[_e1271]), _e1269);
}
}
}
let _e1279 = (bitcast<f32>((bitcast<u32>(_e980) & 2147483647u)) >= 1073741800f);
let _e1282 = ((_e980 * select(1f, _e1064, _e1279)) + 0.5f);
let _e1284 = select(-1073741800f, _e1282, (_e1282 > -1073741800f));
let _e1286 = select(1073741800f, _e1284, (_e1284 < 1073741800f));
let _e1293 = select(0i, select(select(i32(_e1286), i32(-2147483648), (_e1286 < -2147483600f)), 2147483647i, (_e1286 > 2147483500f)), (_e1286 == _e1286));
let _e1297 = (_e1293 - select(0i, 1i, (_e1286 < f32(_e1293))));
let _e1298 = select(0i, 20i, _e1279);
let _e1302 = (bitcast<u32>(_e1297) << bitcast<u32>((_e1298 & 31i)));
let _e1309 = bitcast<u32>(((_e1297 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1298) & 31i))));
if ((_e1302 | _e1309) == 0u) {
} else {
let _e1313 = bitcast<u32>((_e1059 + 8i));
if (_e1313 < _e73) {
let _e1317 = atomicAdd((&global_4.member[_e1313]), _e1302);
phi_2392_ = _e1317;
} else {
phi_2392_ = 0u;
}
let _e1319 = phi_2392_;
let _e1323 = (_e1309 + select(0u, 1u, ((_e1319 + _e1302) < _e1302)));
if (_e1323 == 0u) {
} else {
let _e1325 = (_e1313 + 1u);
if (_e1325 < _e73) {
let _e1329 = atomicAdd((&global_4.member[_e1325]), _e1323);
}
}
}
let _e1333 = (bitcast<f32>((bitcast<u32>(_e981) & 2147483647u)) >= 1073741800f);
let _e1336 = ((_e981 * select(1f, _e1064, _e1333)) + 0.5f);
let _e1338 = select(-1073741800f, _e1336, (_e1336 > -1073741800f));
let _e1340 = select(1073741800f, _e1338, (_e1338 < 1073741800f));
let _e1347 = select(0i, select(select(i32(_e1340), i32(-2147483648), (_e1340 < -2147483600f)), 2147483647i, (_e1340 > 2147483500f)), (_e1340 == _e1340));
let _e1351 = (_e1347 - select(0i, 1i, (_e1340 < f32(_e1347))));
let _e1352 = select(0i, 20i, _e1333);
let _e1356 = (bitcast<u32>(_e1351) << bitcast<u32>((_e1352 & 31i)));
let _e1363 = bitcast<u32>(((_e1351 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1352) & 31i))));
if ((_e1356 | _e1363) == 0u) {
} else {
let _e1367 = bitcast<u32>((_e1059 + 10i));
if (_e1367 < _e73) {
let _e1371 = atomicAdd((&global_4.member[_e1367]), _e1356);
phi_2467_ = _e1371;
} else {
phi_2467_ = 0u;
}
let _e1373 = phi_2467_;
let _e1377 = (_e1363 + select(0u, 1u, ((_e1373 + _e1356) < _e1356)));
if (_e1377 == 0u) {
} else {
let _e1379 = (_e1367 + 1u);
if (_e1379 < _e73) {
let _e1383 = atomicAdd((&global_4.member[_e1379]), _e1377);
}
}
}
phi_1008_ = (_e317 + 1i);
phi_1011_ = (_e319 + _e814);
} else {
phi_1008_ = i32();
phi_1011_ = f32();
}
let _e1387 = phi_1008_;
let _e1389 = phi_1011_;
continue;
continuing {
phi_1007_ = _e1387;
phi_1010_ = _e1389;
break if !(_e320);
}
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
