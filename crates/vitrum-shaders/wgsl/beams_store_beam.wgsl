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
struct type_13 {
member: array<f32>,
}
struct type_16 {
member: u32,
member_1: u32,
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
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
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
member: type_2,
member_1: type_16,
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
member_16: type_5,
member_17: u32,
member_18: type_20,
}
struct type_22 {
member: type_21,
}
struct type_23 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(3)
var<storage, read_write> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_13;
fn function_() {
var local: i32;
var phi_2162_: vec3<f32>;
var phi_2165_: vec3<f32>;
var phi_2178_: type_23;
var phi_2185_: vec3<f32>;
let _e69 = global;
let _e77 = global_1.member.member;
if (_e69.x < _e77.member) {
if (_e69.y < _e77.member_1) {
let _e84 = (_e77.member * _e77.member_1);
let _e86 = ((_e69.y * _e77.member) + _e69.x);
let _e91 = global_1.member.member.member;
let _e95 = global_1.member.member.member_1;
let _e96 = (_e91 * _e95);
let _e98 = ((_e69.y * _e91) + _e69.x);
let _e99 = bitcast<i32>(_e98);
let _e101 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e103 = select(_e101, _e99, (_e99 < _e101));
let _e109 = global_2.member[bitcast<u32>(select(0i, _e103, (_e103 > 0i)))];
let _e111 = bitcast<i32>((_e96 + _e98));
let _e113 = select(_e101, _e111, (_e111 < _e101));
let _e119 = global_2.member[bitcast<u32>(select(0i, _e113, (_e113 > 0i)))];
let _e122 = bitcast<i32>(((2u * _e96) + _e98));
let _e124 = select(_e101, _e122, (_e122 < _e101));
let _e130 = global_2.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e133 = bitcast<i32>(((3u * _e96) + _e98));
let _e135 = select(_e101, _e133, (_e133 < _e101));
let _e141 = global_2.member[bitcast<u32>(select(0i, _e135, (_e135 > 0i)))];
let _e144 = bitcast<i32>(((4u * _e96) + _e98));
let _e146 = select(_e101, _e144, (_e144 < _e101));
let _e152 = global_2.member[bitcast<u32>(select(0i, _e146, (_e146 > 0i)))];
let _e155 = bitcast<i32>(((5u * _e96) + _e98));
let _e157 = select(_e101, _e155, (_e155 < _e101));
let _e163 = global_2.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e166 = bitcast<i32>(((6u * _e96) + _e98));
let _e168 = select(_e101, _e166, (_e166 < _e101));
let _e174 = global_2.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e177 = bitcast<i32>(((7u * _e96) + _e98));
let _e179 = select(_e101, _e177, (_e177 < _e101));
let _e185 = global_2.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e188 = bitcast<i32>(((8u * _e96) + _e98));
let _e190 = select(_e101, _e188, (_e188 < _e101));
let _e196 = global_2.member[bitcast<u32>(select(0i, _e190, (_e190 > 0i)))];
let _e199 = bitcast<i32>(((9u * _e96) + _e98));
let _e201 = select(_e101, _e199, (_e199 < _e101));
let _e207 = global_2.member[bitcast<u32>(select(0i, _e201, (_e201 > 0i)))];
let _e210 = bitcast<i32>(((10u * _e96) + _e98));
let _e212 = select(_e101, _e210, (_e210 < _e101));
let _e218 = global_2.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
let _e221 = bitcast<i32>(((11u * _e96) + _e98));
let _e223 = select(_e101, _e221, (_e221 < _e101));
let _e229 = global_2.member[bitcast<u32>(select(0i, _e223, (_e223 > 0i)))];
let _e232 = bitcast<i32>(((12u * _e96) + _e98));
let _e234 = select(_e101, _e232, (_e232 < _e101));
let _e240 = global_2.member[bitcast<u32>(select(0i, _e234, (_e234 > 0i)))];
let _e243 = bitcast<i32>(((13u * _e96) + _e98));
let _e245 = select(_e101, _e243, (_e243 < _e101));
let _e251 = global_2.member[bitcast<u32>(select(0i, _e245, (_e245 > 0i)))];
let _e254 = bitcast<i32>(((14u * _e96) + _e98));
let _e256 = select(_e101, _e254, (_e254 < _e101));
let _e262 = global_2.member[bitcast<u32>(select(0i, _e256, (_e256 > 0i)))];
let _e265 = bitcast<i32>(((15u * _e96) + _e98));
let _e267 = select(_e101, _e265, (_e265 < _e101));
let _e273 = global_2.member[bitcast<u32>(select(0i, _e267, (_e267 > 0i)))];
let _e276 = bitcast<i32>(((16u * _e96) + _e98));
let _e278 = select(_e101, _e276, (_e276 < _e101));
let _e284 = global_2.member[bitcast<u32>(select(0i, _e278, (_e278 > 0i)))];
let _e287 = bitcast<i32>(((17u * _e96) + _e98));
let _e289 = select(_e101, _e287, (_e287 < _e101));
let _e295 = global_2.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e298 = bitcast<i32>(((18u * _e96) + _e98));
let _e300 = select(_e101, _e298, (_e298 < _e101));
let _e306 = global_2.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e309 = bitcast<i32>(((19u * _e96) + _e98));
let _e311 = select(_e101, _e309, (_e309 < _e101));
let _e317 = global_2.member[bitcast<u32>(select(0i, _e311, (_e311 > 0i)))];
let _e320 = bitcast<i32>(((20u * _e96) + _e98));
let _e322 = select(_e101, _e320, (_e320 < _e101));
let _e328 = global_2.member[bitcast<u32>(select(0i, _e322, (_e322 > 0i)))];
let _e331 = bitcast<i32>(((23u * _e96) + _e98));
let _e333 = select(_e101, _e331, (_e331 < _e101));
let _e339 = global_2.member[bitcast<u32>(select(0i, _e333, (_e333 > 0i)))];
let _e342 = bitcast<i32>(((24u * _e96) + _e98));
let _e344 = select(_e101, _e342, (_e342 < _e101));
let _e350 = global_2.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e353 = bitcast<i32>(((29u * _e96) + _e98));
let _e355 = select(_e101, _e353, (_e353 < _e101));
let _e361 = global_2.member[bitcast<u32>(select(0i, _e355, (_e355 > 0i)))];
let _e364 = bitcast<i32>(((30u * _e96) + _e98));
let _e366 = select(_e101, _e364, (_e364 < _e101));
let _e372 = global_2.member[bitcast<u32>(select(0i, _e366, (_e366 > 0i)))];
let _e375 = bitcast<i32>(((36u * _e96) + _e98));
let _e377 = select(_e101, _e375, (_e375 < _e101));
let _e383 = global_2.member[bitcast<u32>(select(0i, _e377, (_e377 > 0i)))];
let _e390 = select(0i, select(select(i32(_e339), i32(-2147483648), (_e339 < -2147483600f)), 2147483647i, (_e339 > 2147483500f)), (_e339 == _e339));
let _e406 = (_e77.member_2 == 1u);
let _e411 = global_1.member.member_12.member_4;
let _e421 = ((((_e361 == 2f) && (select(0i, select(select(i32(_e383), i32(-2147483648), (_e383 < -2147483600f)), 2147483647i, (_e383 > 2147483500f)), (_e383 == _e383)) == (bitcast<i32>(_e411) + 1i))) && ((select(0i, select(select(i32(_e372), i32(-2147483648), (_e372 < -2147483600f)), 2147483647i, (_e372 > 2147483500f)), (_e372 == _e372)) == 0i) == _e406)) && (!(_e406) || (_e390 >= 0i)));
let _e422 = select(0f, _e350, _e406);
let _e423 = select(_e350, 1e30f, _e406);
let _e431 = (1f / select(_e141, select(1e-12f, -1e-12f, (_e141 < 0f)), (bitcast<f32>((bitcast<u32>(_e141) & 2147483647u)) < 1e-12f)));
let _e439 = (1f / select(_e152, select(1e-12f, -1e-12f, (_e152 < 0f)), (bitcast<f32>((bitcast<u32>(_e152) & 2147483647u)) < 1e-12f)));
let _e447 = (1f / select(_e163, select(1e-12f, -1e-12f, (_e163 < 0f)), (bitcast<f32>((bitcast<u32>(_e163) & 2147483647u)) < 1e-12f)));
let _e451 = global_1.member.member_13.member_4;
let _e458 = global_1.member.member_13.member_5;
let _e463 = ((_e451.member - _e109) * _e431);
let _e465 = ((_e458.member - _e109) * _e431);
let _e467 = ((_e451.member_1 - _e119) * _e439);
let _e469 = ((_e458.member_1 - _e119) * _e439);
let _e471 = ((_e451.member_2 - _e130) * _e447);
let _e473 = ((_e458.member_2 - _e130) * _e447);
let _e475 = select(_e465, _e463, (_e463 < _e465));
let _e477 = select(_e469, _e467, (_e467 < _e469));
let _e479 = select(_e477, _e475, (_e475 > _e477));
let _e481 = select(_e473, _e471, (_e471 < _e473));
let _e483 = select(_e481, _e479, (_e479 > _e481));
let _e485 = select(_e465, _e463, (_e463 > _e465));
let _e487 = select(_e469, _e467, (_e467 > _e469));
let _e489 = select(_e487, _e485, (_e485 < _e487));
let _e491 = select(_e473, _e471, (_e471 > _e473));
let _e493 = select(_e491, _e489, (_e489 < _e491));
let _e495 = select(_e422, _e483, (_e483 > _e422));
let _e497 = select(_e423, _e493, (_e493 < _e423));
let _e504 = (((_e240 * _e240) + (_e251 * _e251)) + (_e262 * _e262));
let _e507 = sqrt(select(0f, _e504, (_e504 > 0f)));
let _e510 = (0.5f / select(1e-20f, _e507, (_e507 > 1e-20f)));
let _e512 = select(_e510, 1f, (1f < _e510));
let _e513 = (_e240 * _e512);
let _e514 = (_e251 * _e512);
let _e515 = (_e262 * _e512);
let _e520 = (((_e273 * _e273) + (_e284 * _e284)) + (_e295 * _e295));
let _e523 = sqrt(select(0f, _e520, (_e520 > 0f)));
let _e526 = (0.5f / select(1e-20f, _e523, (_e523 > 1e-20f)));
let _e528 = select(_e526, 1f, (1f < _e526));
let _e529 = (_e273 * _e528);
let _e530 = (_e284 * _e528);
let _e531 = (_e295 * _e528);
let _e535 = (_e174 + (_e513 * _e495));
let _e536 = (_e185 + (_e514 * _e495));
let _e537 = (_e196 + (_e515 * _e495));
let _e541 = (_e207 + (_e529 * _e495));
let _e542 = (_e218 + (_e530 * _e495));
let _e543 = (_e229 + (_e531 * _e495));
let _e549 = global_1.member.member_11.member_2;
let _e556 = global_1.member.member_11.member_3;
let _e563 = global_1.member.member_11.member_5;
let _e569 = global_1.member.member_11.member_7;
let _e571 = (_e563 + ((f32(bitcast<i32>(_e69.x)) + 0.5f) * _e569));
let _e575 = global_1.member.member_11.member_6;
let _e581 = global_1.member.member_11.member_8;
let _e583 = (_e575 + ((f32(bitcast<i32>(_e69.y)) + 0.5f) * _e581));
let _e596 = global_1.member.member_11.member_1;
let _e603 = global_1.member.member_10.member;
let _e604 = (_e603 == 0u);
let _e605 = (_e596.member + ((_e549.member * _e571) + (_e556.member * _e583)));
let _e606 = (_e596.member_1 + ((_e549.member_1 * _e571) + (_e556.member_1 * _e583)));
let _e607 = (_e596.member_2 + ((_e549.member_2 * _e571) + (_e556.member_2 * _e583)));
let _e612 = (((_e605 * _e605) + (_e606 * _e606)) + (_e607 * _e607));
let _e616 = (1f / sqrt(select(0f, _e612, (_e612 > 0f))));
let _e620 = select((_e605 * _e616), _e596.member, _e604);
let _e621 = select((_e606 * _e616), _e596.member_1, _e604);
let _e622 = select((_e607 * _e616), _e596.member_2, _e604);
let _e624 = select(0f, _e483, (_e483 > 0f));
let _e626 = select(_e495, _e493, (_e493 < _e495));
let _e629 = (select(_e624, _e626, (_e626 > _e624)) - _e624);
let _e631 = select(0f, _e629, (_e629 > 0f));
let _e635 = global_1.member.member_13.member;
let _e640 = -((_e635.member * _e631));
let _e642 = select(-87f, _e640, (_e640 > -87f));
let _e644 = select(88f, _e642, (_e642 < 88f));
let _e646 = ((_e644 * 1.442695f) + 0.5f);
let _e648 = select(-127f, _e646, (_e646 > -127f));
let _e650 = select(128f, _e648, (_e648 < 128f));
let _e657 = select(0i, select(select(i32(_e650), i32(-2147483648), (_e650 < -2147483600f)), 2147483647i, (_e650 > 2147483500f)), (_e650 == _e650));
let _e661 = (_e657 - select(0i, 1i, (_e650 < f32(_e657))));
let _e662 = f32(_e661);
let _e666 = ((_e644 - (_e662 * 0.6933594f)) - (_e662 * -2.1219444e-4f));
let _e688 = -((_e635.member_1 * _e631));
let _e690 = select(-87f, _e688, (_e688 > -87f));
let _e692 = select(88f, _e690, (_e690 < 88f));
let _e694 = ((_e692 * 1.442695f) + 0.5f);
let _e696 = select(-127f, _e694, (_e694 > -127f));
let _e698 = select(128f, _e696, (_e696 < 128f));
let _e705 = select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < -2147483600f)), 2147483647i, (_e698 > 2147483500f)), (_e698 == _e698));
let _e709 = (_e705 - select(0i, 1i, (_e698 < f32(_e705))));
let _e710 = f32(_e709);
let _e714 = ((_e692 - (_e710 * 0.6933594f)) - (_e710 * -2.1219444e-4f));
let _e736 = -((_e635.member_2 * _e631));
let _e738 = select(-87f, _e736, (_e736 > -87f));
let _e740 = select(88f, _e738, (_e738 < 88f));
let _e742 = ((_e740 * 1.442695f) + 0.5f);
let _e744 = select(-127f, _e742, (_e742 > -127f));
let _e746 = select(128f, _e744, (_e744 < 128f));
let _e753 = select(0i, select(select(i32(_e746), i32(-2147483648), (_e746 < -2147483600f)), 2147483647i, (_e746 > 2147483500f)), (_e746 == _e746));
let _e757 = (_e753 - select(0i, 1i, (_e746 < f32(_e753))));
let _e758 = f32(_e757);
let _e762 = ((_e740 - (_e758 * 0.6933594f)) - (_e758 * -2.1219444e-4f));
let _e783 = (_e569 * _e581);
if _e604 {
let _e787 = global_1.member.member_10.member_2;
let _e791 = (3.1415927f * _e783);
phi_2185_ = vec3<f32>((_e787.member * _e791), (_e787.member_1 * _e791), (_e787.member_2 * _e791));
} else {
let _e800 = (((_e620 * _e596.member) + (_e621 * _e596.member_1)) + (_e622 * _e596.member_2));
let _e804 = global_1.member.member_11.member_4;
let _e814 = global_1.member.member_10.member_2;
if _e604 {
let _e822 = global_1.member.member_10.member_1;
phi_2178_ = type_23(vec3<f32>(_e822.member, _e822.member_1, _e822.member_2), vec3<f32>(_e814.member, _e814.member_1, _e814.member_2));
} else {
let _e831 = global_1.member.member_10.member_3;
let _e835 = ((_e804.member + _e620) - _e831.member);
let _e836 = ((_e804.member_1 + _e621) - _e831.member_1);
let _e837 = ((_e804.member_2 + _e622) - _e831.member_2);
let _e842 = (((_e835 * _e835) + (_e836 * _e836)) + (_e837 * _e837));
let _e844 = select(1e-12f, _e842, (_e842 > 1e-12f));
let _e845 = (1f / _e844);
let _e849 = vec3<f32>((_e814.member * _e845), (_e814.member_1 * _e845), (_e814.member_2 * _e845));
if (_e603 == 2u) {
let _e854 = global_1.member.member_10.member_1;
let _e862 = (((_e854.member * _e835) + (_e854.member_1 * _e836)) + (_e854.member_2 * _e837));
let _e865 = (1f / select(1e-20f, _e862, (_e862 > 1e-20f)));
let _e870 = global_1.member.member_10.member_4.member;
let _e879 = ((((_e870.member * _e835) + (_e870.member_1 * _e836)) + (_e870.member_2 * _e837)) * _e865);
let _e884 = global_1.member.member_10.member_4.member_1;
let _e893 = ((((_e884.member * _e835) + (_e884.member_1 * _e836)) + (_e884.member_2 * _e837)) * _e865);
let _e898 = global_1.member.member_10.member_4.member_2;
let _e901 = ((_e879 * _e879) + (_e893 * _e893));
let _e910 = global_1.member.member_10.member_4.member_3;
let _e911 = ((_e898 - sqrt(select(0f, _e901, (_e901 > 0f)))) * _e910);
let _e913 = select(0f, _e911, (_e911 > 0f));
let _e915 = select(1f, _e913, (_e913 < 1f));
let _e921 = select(0f, ((_e915 * _e915) * (3f - (2f * _e915))), (_e862 > 0f));
let _e926 = global_1.member.member_10.member_4.member_5;
if ((_e926 > 0u) && (_e921 > 0f)) {
let _e930 = (0.5f / _e898);
let _e940 = global_1.member.member_10.member_4.member_6;
let _e941 = bitcast<i32>(_e940);
local = bitcast<i32>(_e926);
let _e942 = local;
let _e944 = f32((_e942 - 1i));
let _e946 = f32((_e941 - 1i));
let _e947 = local;
let _e950 = (((0.5f + (_e879 * _e930)) * f32(_e947)) - 0.5f);
let _e952 = select(0f, _e950, (_e950 > 0f));
let _e954 = select(_e944, _e952, (_e952 < _e944));
let _e957 = (((0.5f - (_e893 * _e930)) * f32(_e941)) - 0.5f);
let _e959 = select(0f, _e957, (_e957 > 0f));
let _e961 = select(_e946, _e959, (_e959 < _e946));
let _e963 = select(0f, _e954, (_e954 > 0f));
let _e965 = select(_e944, _e963, (_e963 < _e944));
let _e972 = select(0i, select(select(i32(_e965), i32(-2147483648), (_e965 < -2147483600f)), 2147483647i, (_e965 > 2147483500f)), (_e965 == _e965));
let _e976 = (_e972 - select(0i, 1i, (_e965 < f32(_e972))));
let _e978 = select(0f, _e961, (_e961 > 0f));
let _e980 = select(_e946, _e978, (_e978 < _e946));
let _e987 = select(0i, select(select(i32(_e980), i32(-2147483648), (_e980 < -2147483600f)), 2147483647i, (_e980 > 2147483500f)), (_e980 == _e980));
let _e991 = (_e987 - select(0i, 1i, (_e980 < f32(_e987))));
let _e993 = (_e954 - f32(_e976));
let _e995 = (_e961 - f32(_e991));
let _e996 = (_e976 + 1i);
let _e997 = local;
let _e999 = select(_e976, _e996, (_e996 < _e997));
let _e1000 = (_e991 + 1i);
let _e1002 = select(_e991, _e1000, (_e1000 < _e941));
let _e1007 = global_1.member.member_10.member_4.member_4;
let _e1008 = bitcast<i32>(_e1007);
let _e1009 = local;
let _e1013 = (_e1008 + (3i * ((_e991 * _e1009) + _e976)));
let _e1015 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1017 = select(_e1015, _e1013, (_e1013 < _e1015));
let _e1022 = global_4.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1023 = (_e1013 + 1i);
let _e1025 = select(_e1015, _e1023, (_e1023 < _e1015));
let _e1030 = global_4.member[bitcast<u32>(select(0i, _e1025, (_e1025 > 0i)))];
let _e1031 = (_e1013 + 2i);
let _e1033 = select(_e1015, _e1031, (_e1031 < _e1015));
let _e1038 = global_4.member[bitcast<u32>(select(0i, _e1033, (_e1033 > 0i)))];
let _e1039 = local;
let _e1043 = (_e1008 + (3i * ((_e991 * _e1039) + _e999)));
let _e1045 = select(_e1015, _e1043, (_e1043 < _e1015));
let _e1050 = global_4.member[bitcast<u32>(select(0i, _e1045, (_e1045 > 0i)))];
let _e1051 = (_e1043 + 1i);
let _e1053 = select(_e1015, _e1051, (_e1051 < _e1015));
let _e1058 = global_4.member[bitcast<u32>(select(0i, _e1053, (_e1053 > 0i)))];
let _e1059 = (_e1043 + 2i);
let _e1061 = select(_e1015, _e1059, (_e1059 < _e1015));
let _e1066 = global_4.member[bitcast<u32>(select(0i, _e1061, (_e1061 > 0i)))];
let _e1067 = local;
let _e1071 = (_e1008 + (3i * ((_e1002 * _e1067) + _e976)));
let _e1073 = select(_e1015, _e1071, (_e1071 < _e1015));
let _e1078 = global_4.member[bitcast<u32>(select(0i, _e1073, (_e1073 > 0i)))];
let _e1079 = (_e1071 + 1i);
let _e1081 = select(_e1015, _e1079, (_e1079 < _e1015));
let _e1086 = global_4.member[bitcast<u32>(select(0i, _e1081, (_e1081 > 0i)))];
let _e1087 = (_e1071 + 2i);
let _e1089 = select(_e1015, _e1087, (_e1087 < _e1015));
let _e1094 = global_4.member[bitcast<u32>(select(0i, _e1089, (_e1089 > 0i)))];
let _e1095 = local;
let _e1099 = (_e1008 + (3i * ((_e1002 * _e1095) + _e999)));
let _e1101 = select(_e1015, _e1099, (_e1099 < _e1015));
let _e1106 = global_4.member[bitcast<u32>(select(0i, _e1101, (_e1101 > 0i)))];
let _e1107 = (_e1099 + 1i);
let _e1109 = select(_e1015, _e1107, (_e1107 < _e1015));
let _e1114 = global_4.member[bitcast<u32>(select(0i, _e1109, (_e1109 > 0i)))];
let _e1115 = (_e1099 + 2i);
let _e1117 = select(_e1015, _e1115, (_e1115 < _e1015));
let _e1122 = global_4.member[bitcast<u32>(select(0i, _e1117, (_e1117 > 0i)))];
let _e1129 = (_e1022 + ((_e1050 - _e1022) * _e993));
let _e1130 = (_e1030 + ((_e1058 - _e1030) * _e993));
let _e1131 = (_e1038 + ((_e1066 - _e1038) * _e993));
phi_2162_ = vec3<f32>(((_e1129 + (((_e1078 + ((_e1106 - _e1078) * _e993)) - _e1129) * _e995)) * _e921), ((_e1130 + (((_e1086 + ((_e1114 - _e1086) * _e993)) - _e1130) * _e995)) * _e921), ((_e1131 + (((_e1094 + ((_e1122 - _e1094) * _e993)) - _e1131) * _e995)) * _e921));
} else {
phi_2162_ = vec3(_e921);
}
let _e1156 = phi_2162_;
phi_2165_ = (_e849 * _e1156);
} else {
phi_2165_ = _e849;
}
let _e1159 = phi_2165_;
let _e1163 = (1f / sqrt(select(0f, _e844, (_e844 > 0f))));
phi_2178_ = type_23(vec3<f32>((_e835 * _e1163), (_e836 * _e1163), (_e837 * _e1163)), _e1159);
}
let _e1170 = phi_2178_;
phi_2185_ = (_e1170.member_1 * ((3.1415927f * _e783) * ((_e800 * _e800) * _e800)));
}
let _e1178 = phi_2185_;
let _e1201 = (((_e535 * _e535) + (_e536 * _e536)) + (_e537 * _e537));
let _e1209 = (((_e541 * _e541) + (_e542 * _e542)) + (_e543 * _e543));
let _e1219 = (((_e513 * _e513) + (_e514 * _e514)) + (_e515 * _e515));
let _e1227 = (((_e529 * _e529) + (_e530 * _e530)) + (_e531 * _e531));
global_3.member[_e86] = (_e109 + (_e141 * _e495));
global_3.member[(_e84 + _e86)] = (_e119 + (_e152 * _e495));
global_3.member[((2u * _e84) + _e86)] = (_e130 + (_e163 * _e495));
global_3.member[((3u * _e84) + _e86)] = _e141;
global_3.member[((4u * _e84) + _e86)] = _e152;
global_3.member[((5u * _e84) + _e86)] = _e163;
global_3.member[((6u * _e84) + _e86)] = _e535;
global_3.member[((7u * _e84) + _e86)] = _e536;
global_3.member[((8u * _e84) + _e86)] = _e537;
global_3.member[((9u * _e84) + _e86)] = _e541;
global_3.member[((10u * _e84) + _e86)] = _e542;
global_3.member[((11u * _e84) + _e86)] = _e543;
global_3.member[((12u * _e84) + _e86)] = _e513;
global_3.member[((13u * _e84) + _e86)] = _e514;
global_3.member[((14u * _e84) + _e86)] = _e515;
global_3.member[((15u * _e84) + _e86)] = _e529;
global_3.member[((16u * _e84) + _e86)] = _e530;
global_3.member[((17u * _e84) + _e86)] = _e531;
global_3.member[((18u * _e84) + _e86)] = select(0f, ((_e1178.x * _e306) * ((1f + (_e666 * (1f + (_e666 * (0.5f + (_e666 * (0.16666667f + (_e666 * (0.041666668f + (_e666 * (0.008333334f + (_e666 * (0.001388889f + (_e666 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e661 + 127i)) << bitcast<u32>(23i))))), _e421);
global_3.member[((19u * _e84) + _e86)] = select(0f, ((_e1178.y * _e317) * ((1f + (_e714 * (1f + (_e714 * (0.5f + (_e714 * (0.16666667f + (_e714 * (0.041666668f + (_e714 * (0.008333334f + (_e714 * (0.001388889f + (_e714 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e709 + 127i)) << bitcast<u32>(23i))))), _e421);
global_3.member[((20u * _e84) + _e86)] = select(0f, ((_e1178.z * _e328) * ((1f + (_e762 * (1f + (_e762 * (0.5f + (_e762 * (0.16666667f + (_e762 * (0.041666668f + (_e762 * (0.008333334f + (_e762 * (0.001388889f + (_e762 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e757 + 127i)) << bitcast<u32>(23i))))), _e421);
global_3.member[((21u * _e84) + _e86)] = (0.5f * (sqrt(select(0f, _e1201, (_e1201 > 0f))) + sqrt(select(0f, _e1209, (_e1209 > 0f)))));
global_3.member[((22u * _e84) + _e86)] = (0.5f * (sqrt(select(0f, _e1219, (_e1219 > 0f))) + sqrt(select(0f, _e1227, (_e1227 > 0f)))));
global_3.member[((23u * _e84) + _e86)] = (select(_e495, _e497, (_e497 > _e495)) - _e495);
global_3.member[((24u * _e84) + _e86)] = (_e423 - _e495);
global_3.member[((25u * _e84) + _e86)] = f32(select(_e390, -1i, _e406));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
