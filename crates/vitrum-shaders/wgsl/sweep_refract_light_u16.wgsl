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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_31 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_940_: u32;
var phi_3603_: type_29;
var phi_4381_: type_30;
var phi_5346_: type_5;
var phi_6456_: type_31;
var phi_6608_: vec3<f32>;
var phi_6609_: f32;
let _e83 = global;
let _e86 = arrayLength((&global_2.member));
let _e90 = arrayLength((&global_4.member));
let _e92 = arrayLength((&global_6.member));
let _e97 = global_1.member.member_2;
let _e100 = global_1.member.member;
let _e108 = (_e83.x + _e97.member);
let _e110 = (_e83.y + _e97.member_1);
if (_e108 < _e97.member_2) {
if (_e110 < _e97.member_3) {
let _e113 = (_e100.member * _e100.member_1);
let _e115 = ((_e110 * _e100.member) + _e108);
let _e116 = bitcast<i32>(_e115);
let _e118 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e120 = select(_e118, _e116, (_e116 < _e118));
let _e126 = global_5.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e127 = (_e113 + _e115);
let _e128 = bitcast<i32>(_e127);
let _e130 = select(_e118, _e128, (_e128 < _e118));
let _e136 = global_5.member[bitcast<u32>(select(0i, _e130, (_e130 > 0i)))];
let _e138 = ((2u * _e113) + _e115);
let _e139 = bitcast<i32>(_e138);
let _e141 = select(_e118, _e139, (_e139 < _e118));
let _e147 = global_5.member[bitcast<u32>(select(0i, _e141, (_e141 > 0i)))];
let _e149 = ((3u * _e113) + _e115);
let _e150 = bitcast<i32>(_e149);
let _e152 = select(_e118, _e150, (_e150 < _e118));
let _e158 = global_5.member[bitcast<u32>(select(0i, _e152, (_e152 > 0i)))];
let _e160 = ((4u * _e113) + _e115);
let _e161 = bitcast<i32>(_e160);
let _e163 = select(_e118, _e161, (_e161 < _e118));
let _e169 = global_5.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e171 = ((5u * _e113) + _e115);
let _e172 = bitcast<i32>(_e171);
let _e174 = select(_e118, _e172, (_e172 < _e118));
let _e180 = global_5.member[bitcast<u32>(select(0i, _e174, (_e174 > 0i)))];
let _e182 = ((6u * _e113) + _e115);
let _e183 = bitcast<i32>(_e182);
let _e185 = select(_e118, _e183, (_e183 < _e118));
let _e191 = global_5.member[bitcast<u32>(select(0i, _e185, (_e185 > 0i)))];
let _e193 = ((7u * _e113) + _e115);
let _e194 = bitcast<i32>(_e193);
let _e196 = select(_e118, _e194, (_e194 < _e118));
let _e202 = global_5.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = ((8u * _e113) + _e115);
let _e205 = bitcast<i32>(_e204);
let _e207 = select(_e118, _e205, (_e205 < _e118));
let _e213 = global_5.member[bitcast<u32>(select(0i, _e207, (_e207 > 0i)))];
let _e217 = global_1.member.member_8.member;
let _e221 = global_1.member.member_8.member_1;
let _e222 = (_e217 * _e221);
if (_e92 >= (_e222 * 2u)) {
let _e226 = bitcast<i32>((_e110 * _e217));
let _e228 = bitcast<i32>(_e108);
let _e233 = global_6.member[bitcast<u32>((_e226 + _e228))];
let _e239 = global_6.member[bitcast<u32>(((bitcast<i32>(_e222) + _e226) + _e228))];
let _e240 = f32(_e228);
let _e242 = f32(bitcast<i32>(_e110));
let _e248 = global_1.member.member_5.member;
let _e252 = global_1.member.member_8.member_8;
let _e253 = (_e248 - _e252);
let _e257 = global_1.member.member_8.member_2;
let _e261 = global_1.member.member_8.member_6;
let _e268 = global_1.member.member_8.member_4;
let _e270 = ((_e257 + (_e261 * _e253)) + (((_e240 - _e233) + 0.5f) * _e268));
let _e274 = global_1.member.member_8.member_3;
let _e278 = global_1.member.member_8.member_7;
let _e283 = ((_e274 + (_e278 * _e253)) + (((_e242 - _e239) + 0.5f) * _e268));
let _e287 = global_1.member.member_5.member_1;
let _e288 = (_e287 - _e252);
let _e293 = ((_e257 + (_e261 * _e288)) + ((_e240 + 0.5f) * _e268));
let _e298 = ((_e274 + (_e278 * _e288)) + ((_e242 + 0.5f) * _e268));
let _e302 = global_1.member.member_6.member;
let _e313 = ((((_e302.member.member * _e270) + (_e302.member.member_1 * _e283)) + (_e302.member.member_2 * _e248)) + _e302.member_1);
let _e317 = global_1.member.member_6.member_1;
let _e328 = ((((_e317.member.member * _e270) + (_e317.member.member_1 * _e283)) + (_e317.member.member_2 * _e248)) + _e317.member_1);
let _e332 = global_1.member.member_6.member_2;
let _e343 = ((((_e332.member.member * _e270) + (_e332.member.member_1 * _e283)) + (_e332.member.member_2 * _e248)) + _e332.member_1);
let _e349 = ((((_e302.member.member * _e293) + (_e302.member.member_1 * _e298)) + (_e302.member.member_2 * _e287)) + _e302.member_1);
let _e355 = ((((_e317.member.member * _e293) + (_e317.member.member_1 * _e298)) + (_e317.member.member_2 * _e287)) + _e317.member_1);
let _e361 = ((((_e332.member.member * _e293) + (_e332.member.member_1 * _e298)) + (_e332.member.member_2 * _e287)) + _e332.member_1);
let _e367 = global_1.member.member_6.member_3.member;
let _e368 = (_e367 - 1f);
let _e377 = global_1.member.member_6.member_3.member_1;
let _e378 = (_e377 - 1f);
let _e387 = global_1.member.member_6.member_3.member_2;
let _e388 = (_e387 - 1f);
let _e407 = global_1.member.member_6.member_4;
let _e408 = (_e367 - 0.5f);
let _e410 = select(-0.5f, _e349, (_e349 > -0.5f));
let _e412 = select(_e408, _e410, (_e410 < _e408));
let _e413 = (_e377 - 0.5f);
let _e415 = select(-0.5f, _e355, (_e355 > -0.5f));
let _e417 = select(_e413, _e415, (_e415 < _e413));
let _e418 = (_e387 - 0.5f);
let _e420 = select(-0.5f, _e361, (_e361 > -0.5f));
let _e422 = select(_e418, _e420, (_e420 < _e418));
let _e428 = bitcast<f32>((bitcast<u32>((_e349 - _e313)) & 2147483647u));
let _e431 = bitcast<f32>((bitcast<u32>((_e355 - _e328)) & 2147483647u));
let _e433 = select(_e431, _e428, (_e428 > _e431));
let _e436 = bitcast<f32>((bitcast<u32>((_e361 - _e343)) & 2147483647u));
let _e445 = bitcast<f32>((bitcast<u32>((_e349 - _e412)) & 2147483647u));
let _e448 = bitcast<f32>((bitcast<u32>((_e355 - _e417)) & 2147483647u));
let _e450 = select(_e448, _e445, (_e445 > _e448));
let _e453 = bitcast<f32>((bitcast<u32>((_e361 - _e422)) & 2147483647u));
let _e457 = (_e412 + 0.5f);
let _e459 = select(0f, _e457, (_e457 > 0f));
let _e461 = select(_e368, _e459, (_e459 < _e368));
let _e468 = select(0i, select(select(i32(_e461), i32(-2147483648), (_e461 < -2147483600f)), 2147483647i, (_e461 > 2147483500f)), (_e461 == _e461));
let _e476 = global_1.member.member_6.member_12;
let _e477 = (_e476 & 31u);
let _e480 = (_e417 + 0.5f);
let _e482 = select(0f, _e480, (_e480 > 0f));
let _e484 = select(_e378, _e482, (_e482 < _e378));
let _e491 = select(0i, select(select(i32(_e484), i32(-2147483648), (_e484 < -2147483600f)), 2147483647i, (_e484 > 2147483500f)), (_e484 == _e484));
let _e498 = (_e422 + 0.5f);
let _e500 = select(0f, _e498, (_e498 > 0f));
let _e502 = select(_e388, _e500, (_e500 < _e388));
let _e509 = select(0i, select(select(i32(_e502), i32(-2147483648), (_e502 < -2147483600f)), 2147483647i, (_e502 > 2147483500f)), (_e502 == _e502));
let _e520 = global_1.member.member_6.member_9.member;
let _e526 = global_1.member.member_6.member_9.member_1;
let _e531 = global_1.member.member_6.member_10;
let _e537 = ((bitcast<i32>(_e531) + ((_e468 - select(0i, 1i, (_e461 < f32(_e468)))) >> bitcast<u32>(_e477))) + (bitcast<i32>(_e520) * (((_e491 - select(0i, 1i, (_e484 < f32(_e491)))) >> bitcast<u32>(_e477)) + (bitcast<i32>(_e526) * ((_e509 - select(0i, 1i, (_e502 < f32(_e509)))) >> bitcast<u32>(_e477))))));
let _e539 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e541 = select(_e539, _e537, (_e537 < _e539));
let _e547 = global_3.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e553 = global_1.member.member_1;
phi_940_ = select(select(7u, 3u, (((((((_e313 >= 0f) && (_e313 <= _e368)) && (_e328 >= 0f)) && (_e328 <= _e378)) && (_e343 >= 0f)) && (_e343 <= _e388)) && ((((((_e349 >= 0f) && (_e349 <= _e368)) && (_e355 >= 0f)) && (_e355 <= _e378)) && (_e361 >= 0f)) && (_e361 <= _e388)))), 1u, (((_e553 & 64u) != 0u) || ((((select(_e436, _e433, (_e433 > _e436)) <= _e407) && ((select(_e453, _e450, (_e450 > _e453)) > _e407) || (_e547 != 0u))) && true) && ((_e553 & 32u) != 0u))));
} else {
phi_940_ = 7u;
}
let _e563 = phi_940_;
if (_e563 > 1u) {
let _e569 = bitcast<i32>(((_e110 * _e217) + _e108));
let _e572 = (bitcast<i32>(_e92) - 1i);
let _e574 = select(_e572, _e569, (_e569 < _e572));
let _e580 = global_6.member[bitcast<u32>(select(0i, _e574, (_e574 > 0i)))];
let _e581 = (bitcast<i32>(_e222) + _e569);
let _e583 = select(_e572, _e581, (_e581 < _e572));
let _e589 = global_6.member[bitcast<u32>(select(0i, _e583, (_e583 > 0i)))];
let _e591 = f32(bitcast<i32>(_e108));
let _e593 = f32(bitcast<i32>(_e110));
let _e599 = global_1.member.member_5.member;
let _e603 = global_1.member.member_8.member_8;
let _e604 = (_e599 - _e603);
let _e608 = global_1.member.member_8.member_2;
let _e612 = global_1.member.member_8.member_6;
let _e619 = global_1.member.member_8.member_4;
let _e621 = ((_e608 + (_e612 * _e604)) + (((_e591 - _e580) + 0.5f) * _e619));
let _e625 = global_1.member.member_8.member_3;
let _e629 = global_1.member.member_8.member_7;
let _e634 = ((_e625 + (_e629 * _e604)) + (((_e593 - _e589) + 0.5f) * _e619));
let _e638 = global_1.member.member_5.member_1;
let _e639 = (_e638 - _e603);
let _e644 = ((_e608 + (_e612 * _e639)) + ((_e591 + 0.5f) * _e619));
let _e649 = ((_e625 + (_e629 * _e639)) + ((_e593 + 0.5f) * _e619));
let _e653 = global_1.member.member_6.member;
let _e664 = ((((_e653.member.member * _e621) + (_e653.member.member_1 * _e634)) + (_e653.member.member_2 * _e599)) + _e653.member_1);
let _e668 = global_1.member.member_6.member_1;
let _e679 = ((((_e668.member.member * _e621) + (_e668.member.member_1 * _e634)) + (_e668.member.member_2 * _e599)) + _e668.member_1);
let _e683 = global_1.member.member_6.member_2;
let _e694 = ((((_e683.member.member * _e621) + (_e683.member.member_1 * _e634)) + (_e683.member.member_2 * _e599)) + _e683.member_1);
let _e700 = ((((_e653.member.member * _e644) + (_e653.member.member_1 * _e649)) + (_e653.member.member_2 * _e638)) + _e653.member_1);
let _e706 = ((((_e668.member.member * _e644) + (_e668.member.member_1 * _e649)) + (_e668.member.member_2 * _e638)) + _e668.member_1);
let _e712 = ((((_e683.member.member * _e644) + (_e683.member.member_1 * _e649)) + (_e683.member.member_2 * _e638)) + _e683.member_1);
let _e714 = (_e100.member_2 == 2u);
let _e717 = (((_e100.member_2 == 1u) || _e714) || (_e100.member_2 == 5u));
if _e717 {
let _e722 = global_1.member.member_6.member_3.member;
let _e723 = (_e722 - 0.5f);
let _e725 = select(-0.5f, _e700, (_e700 > -0.5f));
let _e727 = select(_e723, _e725, (_e725 < _e723));
let _e732 = global_1.member.member_6.member_3.member_1;
let _e733 = (_e732 - 0.5f);
let _e735 = select(-0.5f, _e706, (_e706 > -0.5f));
let _e737 = select(_e733, _e735, (_e735 < _e733));
let _e742 = global_1.member.member_6.member_3.member_2;
let _e743 = (_e742 - 0.5f);
let _e745 = select(-0.5f, _e712, (_e712 > -0.5f));
let _e747 = select(_e743, _e745, (_e745 < _e743));
let _e749 = select(-1f, _e727, (_e727 > -1f));
let _e751 = select(_e722, _e749, (_e749 < _e722));
let _e758 = select(0i, select(select(i32(_e751), i32(-2147483648), (_e751 < -2147483600f)), 2147483647i, (_e751 > 2147483500f)), (_e751 == _e751));
let _e762 = (_e758 - select(0i, 1i, (_e751 < f32(_e758))));
let _e764 = select(-1f, _e737, (_e737 > -1f));
let _e766 = select(_e732, _e764, (_e764 < _e732));
let _e773 = select(0i, select(select(i32(_e766), i32(-2147483648), (_e766 < -2147483600f)), 2147483647i, (_e766 > 2147483500f)), (_e766 == _e766));
let _e777 = (_e773 - select(0i, 1i, (_e766 < f32(_e773))));
let _e779 = select(-1f, _e747, (_e747 > -1f));
let _e781 = select(_e742, _e779, (_e779 < _e742));
let _e788 = select(0i, select(select(i32(_e781), i32(-2147483648), (_e781 < -2147483600f)), 2147483647i, (_e781 > 2147483500f)), (_e781 == _e781));
let _e792 = (_e788 - select(0i, 1i, (_e781 < f32(_e788))));
let _e796 = global_1.member.member_6.member_7;
let _e800 = global_1.member.member_6.member_8;
let _e808 = (select(0i, select(select(i32(_e732), i32(-2147483648), (_e732 < -2147483600f)), 2147483647i, (_e732 > 2147483500f)), (_e732 == _e732)) - 1i);
let _e809 = (_e777 - 1i);
let _e814 = (_e777 + 1i);
let _e817 = (_e777 + 2i);
let _e827 = (select(0i, select(select(i32(_e742), i32(-2147483648), (_e742 < -2147483600f)), 2147483647i, (_e742 > 2147483500f)), (_e742 == _e742)) - 1i);
let _e828 = (_e792 - 1i);
let _e833 = (_e792 + 1i);
let _e836 = (_e792 + 2i);
let _e845 = select(0i, select(select(i32(_e722), i32(-2147483648), (_e722 < -2147483600f)), 2147483647i, (_e722 > 2147483500f)), (_e722 == _e722));
let _e846 = (_e845 - 1i);
let _e847 = (_e762 - 1i);
let _e849 = select(0i, _e847, (_e847 > 0i));
let _e851 = select(0i, _e762, (_e762 > 0i));
let _e852 = (_e762 + 1i);
let _e854 = select(_e846, _e852, (_e852 < _e846));
let _e855 = (_e762 + 2i);
let _e858 = (_e845 - 2i);
let _e860 = select(0i, _e858, (_e858 > 0i));
let _e862 = select(_e860, _e849, (_e849 < _e860));
let _e864 = select(_e860, _e851, (_e851 < _e860));
let _e866 = select(_e860, _e854, (_e854 < _e860));
let _e885 = (select(0i, _e809, (_e809 > 0i)) * _e796);
let _e886 = (select(0i, _e777, (_e777 > 0i)) * _e796);
let _e887 = (select(_e808, _e814, (_e814 < _e808)) * _e796);
let _e888 = (select(_e808, _e817, (_e817 < _e808)) * _e796);
let _e889 = (select(0i, _e828, (_e828 > 0i)) * _e800);
let _e890 = (select(0i, _e792, (_e792 > 0i)) * _e800);
let _e891 = (select(_e827, _e833, (_e833 < _e827)) * _e800);
let _e892 = (select(_e827, _e836, (_e836 < _e827)) * _e800);
local_4 = type_28(array<i32, 4>(_e862, _e864, _e866, 0i), array<u32, 6>(bitcast<u32>(((_e849 - _e862) * 16i)), bitcast<u32>(((_e851 - _e862) * 16i)), bitcast<u32>(((_e851 - _e864) * 16i)), bitcast<u32>(((_e854 - _e864) * 16i)), bitcast<u32>(((_e854 - _e866) * 16i)), bitcast<u32>(((select(_e846, _e855, (_e855 < _e846)) - _e866) * 16i))));
local_5 = vec3<f32>((_e727 - f32(_e762)), (_e737 - f32(_e777)), (_e747 - f32(_e792)));
let _e904 = (_e890 + _e886);
let _e907 = local_4.member[0u];
let _e908 = (_e904 + _e907);
let _e910 = (_e908 >> bitcast<u32>(1i));
let _e913 = bitcast<u32>(((_e908 & 1i) * 16i));
let _e915 = (bitcast<i32>(_e86) - 1i);
let _e917 = select(_e915, _e910, (_e910 < _e915));
let _e922 = global_2.member[bitcast<u32>(select(0i, _e917, (_e917 > 0i)))];
let _e926 = (_e910 + 1i);
let _e928 = select(_e915, _e926, (_e926 < _e915));
let _e933 = global_2.member[bitcast<u32>(select(0i, _e928, (_e928 > 0i)))];
let _e940 = ((_e922 >> bitcast<u32>((_e913 & 31u))) | ((_e933 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e913) & 31u))));
let _e943 = local_4.member[2u];
let _e944 = (_e904 + _e943);
let _e946 = (_e944 >> bitcast<u32>(1i));
let _e949 = bitcast<u32>(((_e944 & 1i) * 16i));
let _e951 = select(_e915, _e946, (_e946 < _e915));
let _e956 = global_2.member[bitcast<u32>(select(0i, _e951, (_e951 > 0i)))];
let _e960 = (_e946 + 1i);
let _e962 = select(_e915, _e960, (_e960 < _e915));
let _e967 = global_2.member[bitcast<u32>(select(0i, _e962, (_e962 > 0i)))];
let _e974 = ((_e956 >> bitcast<u32>((_e949 & 31u))) | ((_e967 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e949) & 31u))));
let _e977 = local_4.member_1[0u];
let _e983 = f32(bitcast<i32>(((_e940 >> bitcast<u32>((_e977 & 31u))) & 65535u)));
let _e986 = local_4.member_1[1u];
let _e992 = f32(bitcast<i32>(((_e940 >> bitcast<u32>((_e986 & 31u))) & 65535u)));
let _e995 = local_4.member_1[4u];
let _e1001 = f32(bitcast<i32>(((_e974 >> bitcast<u32>((_e995 & 31u))) & 65535u)));
let _e1004 = local_4.member_1[5u];
let _e1011 = local_5[0u];
let _e1014 = (_e983 + ((_e992 - _e983) * _e1011));
let _e1015 = local_5[0u];
let _e1018 = (_e992 + ((_e1001 - _e992) * _e1015));
let _e1019 = local_5[0u];
let _e1022 = (_e1001 + ((f32(bitcast<i32>(((_e974 >> bitcast<u32>((_e1004 & 31u))) & 65535u))) - _e1001) * _e1019));
let _e1023 = (_e890 + _e887);
let _e1024 = local_4.member[0u];
let _e1025 = (_e1023 + _e1024);
let _e1027 = (_e1025 >> bitcast<u32>(1i));
let _e1030 = bitcast<u32>(((_e1025 & 1i) * 16i));
let _e1032 = select(_e915, _e1027, (_e1027 < _e915));
let _e1037 = global_2.member[bitcast<u32>(select(0i, _e1032, (_e1032 > 0i)))];
let _e1041 = (_e1027 + 1i);
let _e1043 = select(_e915, _e1041, (_e1041 < _e915));
let _e1048 = global_2.member[bitcast<u32>(select(0i, _e1043, (_e1043 > 0i)))];
let _e1055 = ((_e1037 >> bitcast<u32>((_e1030 & 31u))) | ((_e1048 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1030) & 31u))));
let _e1056 = local_4.member[2u];
let _e1057 = (_e1023 + _e1056);
let _e1059 = (_e1057 >> bitcast<u32>(1i));
let _e1062 = bitcast<u32>(((_e1057 & 1i) * 16i));
let _e1064 = select(_e915, _e1059, (_e1059 < _e915));
let _e1069 = global_2.member[bitcast<u32>(select(0i, _e1064, (_e1064 > 0i)))];
let _e1073 = (_e1059 + 1i);
let _e1075 = select(_e915, _e1073, (_e1073 < _e915));
let _e1080 = global_2.member[bitcast<u32>(select(0i, _e1075, (_e1075 > 0i)))];
let _e1087 = ((_e1069 >> bitcast<u32>((_e1062 & 31u))) | ((_e1080 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1062) & 31u))));
let _e1088 = local_4.member_1[0u];
let _e1094 = f32(bitcast<i32>(((_e1055 >> bitcast<u32>((_e1088 & 31u))) & 65535u)));
let _e1095 = local_4.member_1[1u];
let _e1101 = f32(bitcast<i32>(((_e1055 >> bitcast<u32>((_e1095 & 31u))) & 65535u)));
let _e1102 = local_4.member_1[4u];
let _e1108 = f32(bitcast<i32>(((_e1087 >> bitcast<u32>((_e1102 & 31u))) & 65535u)));
let _e1109 = local_4.member_1[5u];
let _e1116 = local_5[0u];
let _e1120 = local_5[0u];
let _e1123 = (_e1101 + ((_e1108 - _e1101) * _e1120));
let _e1124 = local_5[0u];
let _e1128 = (_e891 + _e886);
let _e1129 = local_4.member[0u];
let _e1130 = (_e1128 + _e1129);
let _e1132 = (_e1130 >> bitcast<u32>(1i));
let _e1135 = bitcast<u32>(((_e1130 & 1i) * 16i));
let _e1137 = select(_e915, _e1132, (_e1132 < _e915));
let _e1142 = global_2.member[bitcast<u32>(select(0i, _e1137, (_e1137 > 0i)))];
let _e1146 = (_e1132 + 1i);
let _e1148 = select(_e915, _e1146, (_e1146 < _e915));
let _e1153 = global_2.member[bitcast<u32>(select(0i, _e1148, (_e1148 > 0i)))];
let _e1160 = ((_e1142 >> bitcast<u32>((_e1135 & 31u))) | ((_e1153 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1135) & 31u))));
let _e1161 = local_4.member[2u];
let _e1162 = (_e1128 + _e1161);
let _e1164 = (_e1162 >> bitcast<u32>(1i));
let _e1167 = bitcast<u32>(((_e1162 & 1i) * 16i));
let _e1169 = select(_e915, _e1164, (_e1164 < _e915));
let _e1174 = global_2.member[bitcast<u32>(select(0i, _e1169, (_e1169 > 0i)))];
let _e1178 = (_e1164 + 1i);
let _e1180 = select(_e915, _e1178, (_e1178 < _e915));
let _e1185 = global_2.member[bitcast<u32>(select(0i, _e1180, (_e1180 > 0i)))];
let _e1192 = ((_e1174 >> bitcast<u32>((_e1167 & 31u))) | ((_e1185 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1167) & 31u))));
let _e1193 = local_4.member_1[0u];
let _e1199 = f32(bitcast<i32>(((_e1160 >> bitcast<u32>((_e1193 & 31u))) & 65535u)));
let _e1200 = local_4.member_1[1u];
let _e1206 = f32(bitcast<i32>(((_e1160 >> bitcast<u32>((_e1200 & 31u))) & 65535u)));
let _e1207 = local_4.member_1[4u];
let _e1213 = f32(bitcast<i32>(((_e1192 >> bitcast<u32>((_e1207 & 31u))) & 65535u)));
let _e1214 = local_4.member_1[5u];
let _e1221 = local_5[0u];
let _e1224 = (_e1199 + ((_e1206 - _e1199) * _e1221));
let _e1225 = local_5[0u];
let _e1228 = (_e1206 + ((_e1213 - _e1206) * _e1225));
let _e1229 = local_5[0u];
let _e1232 = (_e1213 + ((f32(bitcast<i32>(((_e1192 >> bitcast<u32>((_e1214 & 31u))) & 65535u))) - _e1213) * _e1229));
let _e1233 = (_e891 + _e887);
let _e1234 = local_4.member[0u];
let _e1235 = (_e1233 + _e1234);
let _e1237 = (_e1235 >> bitcast<u32>(1i));
let _e1240 = bitcast<u32>(((_e1235 & 1i) * 16i));
let _e1242 = select(_e915, _e1237, (_e1237 < _e915));
let _e1247 = global_2.member[bitcast<u32>(select(0i, _e1242, (_e1242 > 0i)))];
let _e1251 = (_e1237 + 1i);
let _e1253 = select(_e915, _e1251, (_e1251 < _e915));
let _e1258 = global_2.member[bitcast<u32>(select(0i, _e1253, (_e1253 > 0i)))];
let _e1265 = ((_e1247 >> bitcast<u32>((_e1240 & 31u))) | ((_e1258 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1240) & 31u))));
let _e1266 = local_4.member[2u];
let _e1267 = (_e1233 + _e1266);
let _e1269 = (_e1267 >> bitcast<u32>(1i));
let _e1272 = bitcast<u32>(((_e1267 & 1i) * 16i));
let _e1274 = select(_e915, _e1269, (_e1269 < _e915));
let _e1279 = global_2.member[bitcast<u32>(select(0i, _e1274, (_e1274 > 0i)))];
let _e1283 = (_e1269 + 1i);
let _e1285 = select(_e915, _e1283, (_e1283 < _e915));
let _e1290 = global_2.member[bitcast<u32>(select(0i, _e1285, (_e1285 > 0i)))];
let _e1297 = ((_e1279 >> bitcast<u32>((_e1272 & 31u))) | ((_e1290 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1272) & 31u))));
let _e1298 = local_4.member_1[0u];
let _e1304 = f32(bitcast<i32>(((_e1265 >> bitcast<u32>((_e1298 & 31u))) & 65535u)));
let _e1305 = local_4.member_1[1u];
let _e1311 = f32(bitcast<i32>(((_e1265 >> bitcast<u32>((_e1305 & 31u))) & 65535u)));
let _e1312 = local_4.member_1[4u];
let _e1318 = f32(bitcast<i32>(((_e1297 >> bitcast<u32>((_e1312 & 31u))) & 65535u)));
let _e1319 = local_4.member_1[5u];
let _e1326 = local_5[0u];
let _e1330 = local_5[0u];
let _e1333 = (_e1311 + ((_e1318 - _e1311) * _e1330));
let _e1334 = local_5[0u];
let _e1341 = local_4.member[1u];
let _e1342 = ((_e890 + _e885) + _e1341);
let _e1344 = (_e1342 >> bitcast<u32>(1i));
let _e1347 = bitcast<u32>(((_e1342 & 1i) * 16i));
let _e1349 = select(_e915, _e1344, (_e1344 < _e915));
let _e1354 = global_2.member[bitcast<u32>(select(0i, _e1349, (_e1349 > 0i)))];
let _e1358 = (_e1344 + 1i);
let _e1360 = select(_e915, _e1358, (_e1358 < _e915));
let _e1365 = global_2.member[bitcast<u32>(select(0i, _e1360, (_e1360 > 0i)))];
let _e1372 = ((_e1354 >> bitcast<u32>((_e1347 & 31u))) | ((_e1365 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1347) & 31u))));
let _e1375 = local_4.member_1[2u];
let _e1381 = f32(bitcast<i32>(((_e1372 >> bitcast<u32>((_e1375 & 31u))) & 65535u)));
let _e1384 = local_4.member_1[3u];
let _e1391 = local_5[0u];
let _e1394 = (_e1381 + ((f32(bitcast<i32>(((_e1372 >> bitcast<u32>((_e1384 & 31u))) & 65535u))) - _e1381) * _e1391));
let _e1396 = local_4.member[1u];
let _e1397 = ((_e890 + _e888) + _e1396);
let _e1399 = (_e1397 >> bitcast<u32>(1i));
let _e1402 = bitcast<u32>(((_e1397 & 1i) * 16i));
let _e1404 = select(_e915, _e1399, (_e1399 < _e915));
let _e1409 = global_2.member[bitcast<u32>(select(0i, _e1404, (_e1404 > 0i)))];
let _e1413 = (_e1399 + 1i);
let _e1415 = select(_e915, _e1413, (_e1413 < _e915));
let _e1420 = global_2.member[bitcast<u32>(select(0i, _e1415, (_e1415 > 0i)))];
let _e1427 = ((_e1409 >> bitcast<u32>((_e1402 & 31u))) | ((_e1420 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1402) & 31u))));
let _e1428 = local_4.member_1[2u];
let _e1434 = f32(bitcast<i32>(((_e1427 >> bitcast<u32>((_e1428 & 31u))) & 65535u)));
let _e1435 = local_4.member_1[3u];
let _e1442 = local_5[0u];
let _e1447 = local_4.member[1u];
let _e1448 = ((_e891 + _e885) + _e1447);
let _e1450 = (_e1448 >> bitcast<u32>(1i));
let _e1453 = bitcast<u32>(((_e1448 & 1i) * 16i));
let _e1455 = select(_e915, _e1450, (_e1450 < _e915));
let _e1460 = global_2.member[bitcast<u32>(select(0i, _e1455, (_e1455 > 0i)))];
let _e1464 = (_e1450 + 1i);
let _e1466 = select(_e915, _e1464, (_e1464 < _e915));
let _e1471 = global_2.member[bitcast<u32>(select(0i, _e1466, (_e1466 > 0i)))];
let _e1478 = ((_e1460 >> bitcast<u32>((_e1453 & 31u))) | ((_e1471 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1453) & 31u))));
let _e1479 = local_4.member_1[2u];
let _e1485 = f32(bitcast<i32>(((_e1478 >> bitcast<u32>((_e1479 & 31u))) & 65535u)));
let _e1486 = local_4.member_1[3u];
let _e1493 = local_5[0u];
let _e1496 = (_e1485 + ((f32(bitcast<i32>(((_e1478 >> bitcast<u32>((_e1486 & 31u))) & 65535u))) - _e1485) * _e1493));
let _e1498 = local_4.member[1u];
let _e1499 = ((_e891 + _e888) + _e1498);
let _e1501 = (_e1499 >> bitcast<u32>(1i));
let _e1504 = bitcast<u32>(((_e1499 & 1i) * 16i));
let _e1506 = select(_e915, _e1501, (_e1501 < _e915));
let _e1511 = global_2.member[bitcast<u32>(select(0i, _e1506, (_e1506 > 0i)))];
let _e1515 = (_e1501 + 1i);
let _e1517 = select(_e915, _e1515, (_e1515 < _e915));
let _e1522 = global_2.member[bitcast<u32>(select(0i, _e1517, (_e1517 > 0i)))];
let _e1529 = ((_e1511 >> bitcast<u32>((_e1504 & 31u))) | ((_e1522 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1504) & 31u))));
let _e1530 = local_4.member_1[2u];
let _e1536 = f32(bitcast<i32>(((_e1529 >> bitcast<u32>((_e1530 & 31u))) & 65535u)));
let _e1537 = local_4.member_1[3u];
let _e1544 = local_5[0u];
let _e1549 = local_4.member[1u];
let _e1550 = ((_e889 + _e886) + _e1549);
let _e1552 = (_e1550 >> bitcast<u32>(1i));
let _e1555 = bitcast<u32>(((_e1550 & 1i) * 16i));
let _e1557 = select(_e915, _e1552, (_e1552 < _e915));
let _e1562 = global_2.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1566 = (_e1552 + 1i);
let _e1568 = select(_e915, _e1566, (_e1566 < _e915));
let _e1573 = global_2.member[bitcast<u32>(select(0i, _e1568, (_e1568 > 0i)))];
let _e1580 = ((_e1562 >> bitcast<u32>((_e1555 & 31u))) | ((_e1573 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1555) & 31u))));
let _e1581 = local_4.member_1[2u];
let _e1587 = f32(bitcast<i32>(((_e1580 >> bitcast<u32>((_e1581 & 31u))) & 65535u)));
let _e1588 = local_4.member_1[3u];
let _e1595 = local_5[0u];
let _e1598 = (_e1587 + ((f32(bitcast<i32>(((_e1580 >> bitcast<u32>((_e1588 & 31u))) & 65535u))) - _e1587) * _e1595));
let _e1600 = local_4.member[1u];
let _e1601 = ((_e892 + _e886) + _e1600);
let _e1603 = (_e1601 >> bitcast<u32>(1i));
let _e1606 = bitcast<u32>(((_e1601 & 1i) * 16i));
let _e1608 = select(_e915, _e1603, (_e1603 < _e915));
let _e1613 = global_2.member[bitcast<u32>(select(0i, _e1608, (_e1608 > 0i)))];
let _e1617 = (_e1603 + 1i);
let _e1619 = select(_e915, _e1617, (_e1617 < _e915));
let _e1624 = global_2.member[bitcast<u32>(select(0i, _e1619, (_e1619 > 0i)))];
let _e1631 = ((_e1613 >> bitcast<u32>((_e1606 & 31u))) | ((_e1624 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1606) & 31u))));
let _e1632 = local_4.member_1[2u];
let _e1638 = f32(bitcast<i32>(((_e1631 >> bitcast<u32>((_e1632 & 31u))) & 65535u)));
let _e1639 = local_4.member_1[3u];
let _e1646 = local_5[0u];
let _e1649 = (_e1638 + ((f32(bitcast<i32>(((_e1631 >> bitcast<u32>((_e1639 & 31u))) & 65535u))) - _e1638) * _e1646));
let _e1651 = local_4.member[1u];
let _e1652 = ((_e889 + _e887) + _e1651);
let _e1654 = (_e1652 >> bitcast<u32>(1i));
let _e1657 = bitcast<u32>(((_e1652 & 1i) * 16i));
let _e1659 = select(_e915, _e1654, (_e1654 < _e915));
let _e1664 = global_2.member[bitcast<u32>(select(0i, _e1659, (_e1659 > 0i)))];
let _e1668 = (_e1654 + 1i);
let _e1670 = select(_e915, _e1668, (_e1668 < _e915));
let _e1675 = global_2.member[bitcast<u32>(select(0i, _e1670, (_e1670 > 0i)))];
let _e1682 = ((_e1664 >> bitcast<u32>((_e1657 & 31u))) | ((_e1675 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1657) & 31u))));
let _e1683 = local_4.member_1[2u];
let _e1689 = f32(bitcast<i32>(((_e1682 >> bitcast<u32>((_e1683 & 31u))) & 65535u)));
let _e1690 = local_4.member_1[3u];
let _e1697 = local_5[0u];
let _e1702 = local_4.member[1u];
let _e1703 = ((_e892 + _e887) + _e1702);
let _e1705 = (_e1703 >> bitcast<u32>(1i));
let _e1708 = bitcast<u32>(((_e1703 & 1i) * 16i));
let _e1710 = select(_e915, _e1705, (_e1705 < _e915));
let _e1715 = global_2.member[bitcast<u32>(select(0i, _e1710, (_e1710 > 0i)))];
let _e1719 = (_e1705 + 1i);
let _e1721 = select(_e915, _e1719, (_e1719 < _e915));
let _e1726 = global_2.member[bitcast<u32>(select(0i, _e1721, (_e1721 > 0i)))];
let _e1733 = ((_e1715 >> bitcast<u32>((_e1708 & 31u))) | ((_e1726 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1708) & 31u))));
let _e1734 = local_4.member_1[2u];
let _e1740 = f32(bitcast<i32>(((_e1733 >> bitcast<u32>((_e1734 & 31u))) & 65535u)));
let _e1741 = local_4.member_1[3u];
let _e1748 = local_5[0u];
let _e1753 = local_5[1u];
let _e1756 = (_e1018 + ((_e1123 - _e1018) * _e1753));
let _e1757 = local_5[1u];
let _e1760 = (_e1228 + ((_e1333 - _e1228) * _e1757));
let _e1761 = local_5[1u];
let _e1764 = (_e1014 + (((_e1094 + ((_e1101 - _e1094) * _e1116)) - _e1014) * _e1761));
let _e1765 = local_5[1u];
let _e1770 = local_5[2u];
let _e1774 = local_5[1u];
let _e1777 = (_e1022 + (((_e1108 + ((f32(bitcast<i32>(((_e1087 >> bitcast<u32>((_e1109 & 31u))) & 65535u))) - _e1108) * _e1124)) - _e1022) * _e1774));
let _e1778 = local_5[1u];
let _e1782 = local_5[2u];
let _e1786 = local_5[1u];
let _e1789 = (_e1394 + ((_e1018 - _e1394) * _e1786));
let _e1790 = local_5[1u];
let _e1794 = local_5[2u];
let _e1798 = local_5[1u];
let _e1801 = (_e1123 + (((_e1434 + ((f32(bitcast<i32>(((_e1427 >> bitcast<u32>((_e1435 & 31u))) & 65535u))) - _e1434) * _e1442)) - _e1123) * _e1798));
let _e1802 = local_5[1u];
let _e1806 = local_5[2u];
let _e1810 = local_5[1u];
let _e1813 = (_e1598 + (((_e1689 + ((f32(bitcast<i32>(((_e1682 >> bitcast<u32>((_e1690 & 31u))) & 65535u))) - _e1689) * _e1697)) - _e1598) * _e1810));
let _e1814 = local_5[2u];
let _e1818 = local_5[1u];
let _e1822 = local_5[2u];
let _e1826 = local_5[2u];
let _e1833 = global_1.member.member_6.member_5;
let _e1838 = global_1.member.member_6.member_6;
let _e1839 = (((_e1756 + ((_e1760 - _e1756) * _e1826)) * _e1833) + _e1838);
let _e1841 = select(0f, _e1839, (_e1839 > 0f));
let _e1843 = select(1f, _e1841, (_e1841 < 1f));
let _e1845 = (((_e1764 + (((_e1224 + (((_e1304 + ((_e1311 - _e1304) * _e1326)) - _e1224) * _e1765)) - _e1764) * _e1770)) * _e1833) + _e1838);
let _e1847 = select(0f, _e1845, (_e1845 > 0f));
let _e1849 = select(1f, _e1847, (_e1847 < 1f));
let _e1851 = (((_e1777 + (((_e1232 + (((_e1318 + ((f32(bitcast<i32>(((_e1297 >> bitcast<u32>((_e1319 & 31u))) & 65535u))) - _e1318) * _e1334)) - _e1232) * _e1778)) - _e1777) * _e1782)) * _e1833) + _e1838);
let _e1853 = select(0f, _e1851, (_e1851 > 0f));
let _e1855 = select(1f, _e1853, (_e1853 < 1f));
let _e1857 = (((_e1789 + (((_e1496 + ((_e1228 - _e1496) * _e1790)) - _e1789) * _e1794)) * _e1833) + _e1838);
let _e1859 = select(0f, _e1857, (_e1857 > 0f));
let _e1861 = select(1f, _e1859, (_e1859 < 1f));
let _e1863 = (((_e1801 + (((_e1333 + (((_e1536 + ((f32(bitcast<i32>(((_e1529 >> bitcast<u32>((_e1537 & 31u))) & 65535u))) - _e1536) * _e1544)) - _e1333) * _e1802)) - _e1801) * _e1806)) * _e1833) + _e1838);
let _e1865 = select(0f, _e1863, (_e1863 > 0f));
let _e1867 = select(1f, _e1865, (_e1865 < 1f));
let _e1869 = (((_e1813 + ((_e1756 - _e1813) * _e1814)) * _e1833) + _e1838);
let _e1871 = select(0f, _e1869, (_e1869 > 0f));
let _e1873 = select(1f, _e1871, (_e1871 < 1f));
let _e1875 = (((_e1760 + (((_e1649 + (((_e1740 + ((f32(bitcast<i32>(((_e1733 >> bitcast<u32>((_e1741 & 31u))) & 65535u))) - _e1740) * _e1748)) - _e1649) * _e1818)) - _e1760) * _e1822)) * _e1833) + _e1838);
let _e1877 = select(0f, _e1875, (_e1875 > 0f));
let _e1879 = select(1f, _e1877, (_e1877 < 1f));
let _e1880 = (_e1843 * 1024f);
let _e1881 = (1024f - 1f);
let _e1883 = select(0f, _e1880, (_e1880 > 0f));
let _e1885 = select(_e1881, _e1883, (_e1883 < _e1881));
let _e1892 = select(0i, select(select(i32(_e1885), i32(-2147483648), (_e1885 < -2147483600f)), 2147483647i, (_e1885 > 2147483500f)), (_e1885 == _e1885));
let _e1896 = (_e1892 - select(0i, 1i, (_e1885 < f32(_e1892))));
let _e1897 = (262147i + _e1896);
let _e1899 = (bitcast<i32>(_e90) - 1i);
let _e1901 = select(_e1899, _e1897, (_e1897 < _e1899));
let _e1907 = global_4.member[bitcast<u32>(select(0i, _e1901, (_e1901 > 0i)))];
let _e1917 = select(_e1899, 262146i, (262146i < _e1899));
let _e1923 = global_4.member[bitcast<u32>(select(0i, _e1917, (_e1917 > 0i)))];
let _e1924 = bitcast<f32>(_e1923);
let _e1925 = (f32((bitcast<i32>((_e1907 & 4095u)) - 2048i)) * _e1924);
let _e1927 = select(_e1899, 262144i, (262144i < _e1899));
let _e1933 = global_4.member[bitcast<u32>(select(0i, _e1927, (_e1927 > 0i)))];
let _e1934 = bitcast<f32>(_e1933);
let _e1936 = select(_e1899, 262145i, (262145i < _e1899));
let _e1942 = global_4.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1943 = bitcast<f32>(_e1942);
let _e1949 = ((_e1934 + (f32(bitcast<i32>((_e1907 >> bitcast<u32>(12u)))) * _e1943)) + (_e1925 * (_e1880 - f32(_e1896))));
let _e1950 = (_e1925 * 1024f);
if _e714 {
let _e1957 = ((0.5f * (_e1855 - _e1849)) * _e1950);
let _e1958 = ((0.5f * (_e1867 - _e1861)) * _e1950);
let _e1959 = ((0.5f * (_e1879 - _e1873)) * _e1950);
phi_3603_ = type_29(_e1949, vec3<f32>(_e1957, _e1958, _e1959), vec3<f32>((_e1957 * _e1949), (_e1958 * _e1949), (_e1959 * _e1949)));
} else {
let _e1966 = (_e1849 * 1024f);
let _e1968 = select(0f, _e1966, (_e1966 > 0f));
let _e1970 = select(_e1881, _e1968, (_e1968 < _e1881));
let _e1977 = select(0i, select(select(i32(_e1970), i32(-2147483648), (_e1970 < -2147483600f)), 2147483647i, (_e1970 > 2147483500f)), (_e1970 == _e1970));
let _e1981 = (_e1977 - select(0i, 1i, (_e1970 < f32(_e1977))));
let _e1982 = (262147i + _e1981);
let _e1984 = select(_e1899, _e1982, (_e1982 < _e1899));
let _e1990 = global_4.member[bitcast<u32>(select(0i, _e1984, (_e1984 > 0i)))];
let _e2005 = ((_e1934 + (f32(bitcast<i32>((_e1990 >> bitcast<u32>(12u)))) * _e1943)) + ((f32((bitcast<i32>((_e1990 & 4095u)) - 2048i)) * _e1924) * (_e1966 - f32(_e1981))));
let _e2006 = (_e1855 * 1024f);
let _e2008 = select(0f, _e2006, (_e2006 > 0f));
let _e2010 = select(_e1881, _e2008, (_e2008 < _e1881));
let _e2017 = select(0i, select(select(i32(_e2010), i32(-2147483648), (_e2010 < -2147483600f)), 2147483647i, (_e2010 > 2147483500f)), (_e2010 == _e2010));
let _e2021 = (_e2017 - select(0i, 1i, (_e2010 < f32(_e2017))));
let _e2022 = (262147i + _e2021);
let _e2024 = select(_e1899, _e2022, (_e2022 < _e1899));
let _e2030 = global_4.member[bitcast<u32>(select(0i, _e2024, (_e2024 > 0i)))];
let _e2045 = ((_e1934 + (f32(bitcast<i32>((_e2030 >> bitcast<u32>(12u)))) * _e1943)) + ((f32((bitcast<i32>((_e2030 & 4095u)) - 2048i)) * _e1924) * (_e2006 - f32(_e2021))));
let _e2046 = (_e1861 * 1024f);
let _e2048 = select(0f, _e2046, (_e2046 > 0f));
let _e2050 = select(_e1881, _e2048, (_e2048 < _e1881));
let _e2057 = select(0i, select(select(i32(_e2050), i32(-2147483648), (_e2050 < -2147483600f)), 2147483647i, (_e2050 > 2147483500f)), (_e2050 == _e2050));
let _e2061 = (_e2057 - select(0i, 1i, (_e2050 < f32(_e2057))));
let _e2062 = (262147i + _e2061);
let _e2064 = select(_e1899, _e2062, (_e2062 < _e1899));
let _e2070 = global_4.member[bitcast<u32>(select(0i, _e2064, (_e2064 > 0i)))];
let _e2085 = ((_e1934 + (f32(bitcast<i32>((_e2070 >> bitcast<u32>(12u)))) * _e1943)) + ((f32((bitcast<i32>((_e2070 & 4095u)) - 2048i)) * _e1924) * (_e2046 - f32(_e2061))));
let _e2086 = (_e1867 * 1024f);
let _e2088 = select(0f, _e2086, (_e2086 > 0f));
let _e2090 = select(_e1881, _e2088, (_e2088 < _e1881));
let _e2097 = select(0i, select(select(i32(_e2090), i32(-2147483648), (_e2090 < -2147483600f)), 2147483647i, (_e2090 > 2147483500f)), (_e2090 == _e2090));
let _e2101 = (_e2097 - select(0i, 1i, (_e2090 < f32(_e2097))));
let _e2102 = (262147i + _e2101);
let _e2104 = select(_e1899, _e2102, (_e2102 < _e1899));
let _e2110 = global_4.member[bitcast<u32>(select(0i, _e2104, (_e2104 > 0i)))];
let _e2125 = ((_e1934 + (f32(bitcast<i32>((_e2110 >> bitcast<u32>(12u)))) * _e1943)) + ((f32((bitcast<i32>((_e2110 & 4095u)) - 2048i)) * _e1924) * (_e2086 - f32(_e2101))));
let _e2126 = (_e1873 * 1024f);
let _e2128 = select(0f, _e2126, (_e2126 > 0f));
let _e2130 = select(_e1881, _e2128, (_e2128 < _e1881));
let _e2137 = select(0i, select(select(i32(_e2130), i32(-2147483648), (_e2130 < -2147483600f)), 2147483647i, (_e2130 > 2147483500f)), (_e2130 == _e2130));
let _e2141 = (_e2137 - select(0i, 1i, (_e2130 < f32(_e2137))));
let _e2142 = (262147i + _e2141);
let _e2144 = select(_e1899, _e2142, (_e2142 < _e1899));
let _e2150 = global_4.member[bitcast<u32>(select(0i, _e2144, (_e2144 > 0i)))];
let _e2165 = ((_e1934 + (f32(bitcast<i32>((_e2150 >> bitcast<u32>(12u)))) * _e1943)) + ((f32((bitcast<i32>((_e2150 & 4095u)) - 2048i)) * _e1924) * (_e2126 - f32(_e2141))));
let _e2166 = (_e1879 * 1024f);
let _e2168 = select(0f, _e2166, (_e2166 > 0f));
let _e2170 = select(_e1881, _e2168, (_e2168 < _e1881));
let _e2177 = select(0i, select(select(i32(_e2170), i32(-2147483648), (_e2170 < -2147483600f)), 2147483647i, (_e2170 > 2147483500f)), (_e2170 == _e2170));
let _e2181 = (_e2177 - select(0i, 1i, (_e2170 < f32(_e2177))));
let _e2182 = (262147i + _e2181);
let _e2184 = select(_e1899, _e2182, (_e2182 < _e1899));
let _e2190 = global_4.member[bitcast<u32>(select(0i, _e2184, (_e2184 > 0i)))];
let _e2205 = ((_e1934 + (f32(bitcast<i32>((_e2190 >> bitcast<u32>(12u)))) * _e1943)) + ((f32((bitcast<i32>((_e2190 & 4095u)) - 2048i)) * _e1924) * (_e2166 - f32(_e2181))));
let _e2206 = (_e2045 - _e2005);
let _e2208 = (_e2125 - _e2085);
let _e2210 = (_e2205 - _e2165);
phi_3603_ = type_29(_e1949, vec3<f32>((0.5f * _e2206), (0.5f * _e2208), (0.5f * _e2210)), vec3<f32>((0.25f * (_e2206 * (_e2045 + _e2005))), (0.25f * (_e2208 * (_e2125 + _e2085))), (0.25f * (_e2210 * (_e2205 + _e2165)))));
}
let _e2225 = phi_3603_;
let _e2240 = select(0f, 1f, ((((((_e700 >= -0.5f) && (_e700 <= _e723)) && (_e706 >= -0.5f)) && (_e706 <= _e733)) && (_e712 >= -0.5f)) && (_e712 <= _e743)));
let _e2242 = (0.5f * (_e1855 - _e1849));
let _e2244 = (0.5f * (_e1867 - _e1861));
let _e2246 = (0.5f * (_e1879 - _e1873));
let _e2252 = global_1.member.member_6.member.member.member;
let _e2258 = global_1.member.member_6.member.member.member_1;
let _e2264 = global_1.member.member_6.member.member.member_2;
let _e2270 = global_1.member.member_6.member_1.member.member;
let _e2276 = global_1.member.member_6.member_1.member.member_1;
let _e2282 = global_1.member.member_6.member_1.member.member_2;
let _e2288 = global_1.member.member_6.member_2.member.member;
let _e2294 = global_1.member.member_6.member_2.member.member_1;
let _e2300 = global_1.member.member_6.member_2.member.member_2;
phi_4381_ = type_30(_e1843, vec3<f32>(((((_e2252 * _e2242) + (_e2270 * _e2244)) + (_e2288 * _e2246)) * _e2240), ((((_e2258 * _e2242) + (_e2276 * _e2244)) + (_e2294 * _e2246)) * _e2240), ((((_e2264 * _e2242) + (_e2282 * _e2244)) + (_e2300 * _e2246)) * _e2240)), _e2225.member, vec3<f32>(((((_e2252 * _e2225.member_2.x) + (_e2270 * _e2225.member_2.y)) + (_e2288 * _e2225.member_2.z)) * _e2240), ((((_e2258 * _e2225.member_2.x) + (_e2276 * _e2225.member_2.y)) + (_e2294 * _e2225.member_2.z)) * _e2240), ((((_e2264 * _e2225.member_2.x) + (_e2282 * _e2225.member_2.y)) + (_e2300 * _e2225.member_2.z)) * _e2240)), vec3<f32>(((((_e2252 * _e2225.member_1.x) + (_e2270 * _e2225.member_1.y)) + (_e2288 * _e2225.member_1.z)) * _e2240), ((((_e2258 * _e2225.member_1.x) + (_e2276 * _e2225.member_1.y)) + (_e2294 * _e2225.member_1.z)) * _e2240), ((((_e2264 * _e2225.member_1.x) + (_e2282 * _e2225.member_1.y)) + (_e2300 * _e2225.member_1.z)) * _e2240)));
} else {
let _e2369 = global_1.member.member_6.member_3.member;
let _e2370 = (_e2369 - 0.5f);
let _e2372 = select(-0.5f, _e700, (_e700 > -0.5f));
let _e2374 = select(_e2370, _e2372, (_e2372 < _e2370));
let _e2379 = global_1.member.member_6.member_3.member_1;
let _e2380 = (_e2379 - 0.5f);
let _e2382 = select(-0.5f, _e706, (_e706 > -0.5f));
let _e2384 = select(_e2380, _e2382, (_e2382 < _e2380));
let _e2389 = global_1.member.member_6.member_3.member_2;
let _e2390 = (_e2389 - 0.5f);
let _e2392 = select(-0.5f, _e712, (_e712 > -0.5f));
let _e2394 = select(_e2390, _e2392, (_e2392 < _e2390));
let _e2396 = select(-1f, _e2374, (_e2374 > -1f));
let _e2398 = select(_e2369, _e2396, (_e2396 < _e2369));
let _e2405 = select(0i, select(select(i32(_e2398), i32(-2147483648), (_e2398 < -2147483600f)), 2147483647i, (_e2398 > 2147483500f)), (_e2398 == _e2398));
let _e2409 = (_e2405 - select(0i, 1i, (_e2398 < f32(_e2405))));
let _e2411 = select(-1f, _e2384, (_e2384 > -1f));
let _e2413 = select(_e2379, _e2411, (_e2411 < _e2379));
let _e2420 = select(0i, select(select(i32(_e2413), i32(-2147483648), (_e2413 < -2147483600f)), 2147483647i, (_e2413 > 2147483500f)), (_e2413 == _e2413));
let _e2424 = (_e2420 - select(0i, 1i, (_e2413 < f32(_e2420))));
let _e2426 = select(-1f, _e2394, (_e2394 > -1f));
let _e2428 = select(_e2389, _e2426, (_e2426 < _e2389));
let _e2435 = select(0i, select(select(i32(_e2428), i32(-2147483648), (_e2428 < -2147483600f)), 2147483647i, (_e2428 > 2147483500f)), (_e2428 == _e2428));
let _e2439 = (_e2435 - select(0i, 1i, (_e2428 < f32(_e2435))));
let _e2443 = global_1.member.member_6.member_7;
let _e2447 = global_1.member.member_6.member_8;
let _e2455 = (select(0i, select(select(i32(_e2379), i32(-2147483648), (_e2379 < -2147483600f)), 2147483647i, (_e2379 > 2147483500f)), (_e2379 == _e2379)) - 1i);
let _e2458 = (_e2424 + 1i);
let _e2468 = (select(0i, select(select(i32(_e2389), i32(-2147483648), (_e2389 < -2147483600f)), 2147483647i, (_e2389 > 2147483500f)), (_e2389 == _e2389)) - 1i);
let _e2471 = (_e2439 + 1i);
let _e2480 = select(0i, select(select(i32(_e2369), i32(-2147483648), (_e2369 < -2147483600f)), 2147483647i, (_e2369 > 2147483500f)), (_e2369 == _e2369));
let _e2481 = (_e2480 - 1i);
let _e2482 = (_e2409 - 1i);
let _e2484 = select(0i, _e2482, (_e2482 > 0i));
let _e2486 = select(0i, _e2409, (_e2409 > 0i));
let _e2487 = (_e2409 + 1i);
let _e2489 = select(_e2481, _e2487, (_e2487 < _e2481));
let _e2490 = (_e2409 + 2i);
let _e2493 = (_e2480 - 2i);
let _e2495 = select(0i, _e2493, (_e2493 > 0i));
let _e2497 = select(_e2495, _e2484, (_e2484 < _e2495));
let _e2499 = select(_e2495, _e2486, (_e2486 < _e2495));
let _e2501 = select(_e2495, _e2489, (_e2489 < _e2495));
let _e2520 = (select(0i, _e2424, (_e2424 > 0i)) * _e2443);
let _e2521 = (select(_e2455, _e2458, (_e2458 < _e2455)) * _e2443);
let _e2522 = (select(0i, _e2439, (_e2439 > 0i)) * _e2447);
let _e2523 = (select(_e2468, _e2471, (_e2471 < _e2468)) * _e2447);
local_2 = type_28(array<i32, 4>(_e2497, _e2499, _e2501, 0i), array<u32, 6>(bitcast<u32>(((_e2484 - _e2497) * 16i)), bitcast<u32>(((_e2486 - _e2497) * 16i)), bitcast<u32>(((_e2486 - _e2499) * 16i)), bitcast<u32>(((_e2489 - _e2499) * 16i)), bitcast<u32>(((_e2489 - _e2501) * 16i)), bitcast<u32>(((select(_e2481, _e2490, (_e2490 < _e2481)) - _e2501) * 16i))));
local_3 = vec3<f32>((_e2374 - f32(_e2409)), (_e2384 - f32(_e2424)), (_e2394 - f32(_e2439)));
let _e2538 = local_2.member[1u];
let _e2539 = ((_e2522 + _e2520) + _e2538);
let _e2541 = (_e2539 >> bitcast<u32>(1i));
let _e2544 = bitcast<u32>(((_e2539 & 1i) * 16i));
let _e2546 = (bitcast<i32>(_e86) - 1i);
let _e2548 = select(_e2546, _e2541, (_e2541 < _e2546));
let _e2553 = global_2.member[bitcast<u32>(select(0i, _e2548, (_e2548 > 0i)))];
let _e2557 = (_e2541 + 1i);
let _e2559 = select(_e2546, _e2557, (_e2557 < _e2546));
let _e2564 = global_2.member[bitcast<u32>(select(0i, _e2559, (_e2559 > 0i)))];
let _e2571 = ((_e2553 >> bitcast<u32>((_e2544 & 31u))) | ((_e2564 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2544) & 31u))));
let _e2574 = local_2.member_1[2u];
let _e2580 = f32(bitcast<i32>(((_e2571 >> bitcast<u32>((_e2574 & 31u))) & 65535u)));
let _e2583 = local_2.member_1[3u];
let _e2590 = local_3[0u];
let _e2593 = (_e2580 + ((f32(bitcast<i32>(((_e2571 >> bitcast<u32>((_e2583 & 31u))) & 65535u))) - _e2580) * _e2590));
let _e2595 = local_2.member[1u];
let _e2596 = ((_e2522 + _e2521) + _e2595);
let _e2598 = (_e2596 >> bitcast<u32>(1i));
let _e2601 = bitcast<u32>(((_e2596 & 1i) * 16i));
let _e2603 = select(_e2546, _e2598, (_e2598 < _e2546));
let _e2608 = global_2.member[bitcast<u32>(select(0i, _e2603, (_e2603 > 0i)))];
let _e2612 = (_e2598 + 1i);
let _e2614 = select(_e2546, _e2612, (_e2612 < _e2546));
let _e2619 = global_2.member[bitcast<u32>(select(0i, _e2614, (_e2614 > 0i)))];
let _e2626 = ((_e2608 >> bitcast<u32>((_e2601 & 31u))) | ((_e2619 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2601) & 31u))));
let _e2627 = local_2.member_1[2u];
let _e2633 = f32(bitcast<i32>(((_e2626 >> bitcast<u32>((_e2627 & 31u))) & 65535u)));
let _e2634 = local_2.member_1[3u];
let _e2641 = local_3[0u];
let _e2646 = local_3[1u];
let _e2649 = (_e2593 + (((_e2633 + ((f32(bitcast<i32>(((_e2626 >> bitcast<u32>((_e2634 & 31u))) & 65535u))) - _e2633) * _e2641)) - _e2593) * _e2646));
let _e2651 = local_2.member[1u];
let _e2652 = ((_e2523 + _e2520) + _e2651);
let _e2654 = (_e2652 >> bitcast<u32>(1i));
let _e2657 = bitcast<u32>(((_e2652 & 1i) * 16i));
let _e2659 = select(_e2546, _e2654, (_e2654 < _e2546));
let _e2664 = global_2.member[bitcast<u32>(select(0i, _e2659, (_e2659 > 0i)))];
let _e2668 = (_e2654 + 1i);
let _e2670 = select(_e2546, _e2668, (_e2668 < _e2546));
let _e2675 = global_2.member[bitcast<u32>(select(0i, _e2670, (_e2670 > 0i)))];
let _e2682 = ((_e2664 >> bitcast<u32>((_e2657 & 31u))) | ((_e2675 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2657) & 31u))));
let _e2683 = local_2.member_1[2u];
let _e2689 = f32(bitcast<i32>(((_e2682 >> bitcast<u32>((_e2683 & 31u))) & 65535u)));
let _e2690 = local_2.member_1[3u];
let _e2697 = local_3[0u];
let _e2700 = (_e2689 + ((f32(bitcast<i32>(((_e2682 >> bitcast<u32>((_e2690 & 31u))) & 65535u))) - _e2689) * _e2697));
let _e2702 = local_2.member[1u];
let _e2703 = ((_e2523 + _e2521) + _e2702);
let _e2705 = (_e2703 >> bitcast<u32>(1i));
let _e2708 = bitcast<u32>(((_e2703 & 1i) * 16i));
let _e2710 = select(_e2546, _e2705, (_e2705 < _e2546));
let _e2715 = global_2.member[bitcast<u32>(select(0i, _e2710, (_e2710 > 0i)))];
let _e2719 = (_e2705 + 1i);
let _e2721 = select(_e2546, _e2719, (_e2719 < _e2546));
let _e2726 = global_2.member[bitcast<u32>(select(0i, _e2721, (_e2721 > 0i)))];
let _e2733 = ((_e2715 >> bitcast<u32>((_e2708 & 31u))) | ((_e2726 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2708) & 31u))));
let _e2734 = local_2.member_1[2u];
let _e2740 = f32(bitcast<i32>(((_e2733 >> bitcast<u32>((_e2734 & 31u))) & 65535u)));
let _e2741 = local_2.member_1[3u];
let _e2748 = local_3[0u];
let _e2752 = local_3[1u];
let _e2757 = local_3[2u];
let _e2764 = global_1.member.member_6.member_5;
let _e2769 = global_1.member.member_6.member_6;
let _e2770 = (((_e2649 + (((_e2700 + (((_e2740 + ((f32(bitcast<i32>(((_e2733 >> bitcast<u32>((_e2741 & 31u))) & 65535u))) - _e2740) * _e2748)) - _e2700) * _e2752)) - _e2649) * _e2757)) * _e2764) + _e2769);
let _e2772 = select(0f, _e2770, (_e2770 > 0f));
phi_4381_ = type_30(select(1f, _e2772, (_e2772 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2777 = phi_4381_;
let _e2782 = global_1.member.member_6.member_3.member;
let _e2783 = (_e2782 - 0.5f);
let _e2785 = select(-0.5f, _e664, (_e664 > -0.5f));
let _e2787 = select(_e2783, _e2785, (_e2785 < _e2783));
let _e2792 = global_1.member.member_6.member_3.member_1;
let _e2793 = (_e2792 - 0.5f);
let _e2795 = select(-0.5f, _e679, (_e679 > -0.5f));
let _e2797 = select(_e2793, _e2795, (_e2795 < _e2793));
let _e2802 = global_1.member.member_6.member_3.member_2;
let _e2803 = (_e2802 - 0.5f);
let _e2805 = select(-0.5f, _e694, (_e694 > -0.5f));
let _e2807 = select(_e2803, _e2805, (_e2805 < _e2803));
let _e2809 = select(-1f, _e2787, (_e2787 > -1f));
let _e2811 = select(_e2782, _e2809, (_e2809 < _e2782));
let _e2818 = select(0i, select(select(i32(_e2811), i32(-2147483648), (_e2811 < -2147483600f)), 2147483647i, (_e2811 > 2147483500f)), (_e2811 == _e2811));
let _e2822 = (_e2818 - select(0i, 1i, (_e2811 < f32(_e2818))));
let _e2824 = select(-1f, _e2797, (_e2797 > -1f));
let _e2826 = select(_e2792, _e2824, (_e2824 < _e2792));
let _e2833 = select(0i, select(select(i32(_e2826), i32(-2147483648), (_e2826 < -2147483600f)), 2147483647i, (_e2826 > 2147483500f)), (_e2826 == _e2826));
let _e2837 = (_e2833 - select(0i, 1i, (_e2826 < f32(_e2833))));
let _e2839 = select(-1f, _e2807, (_e2807 > -1f));
let _e2841 = select(_e2802, _e2839, (_e2839 < _e2802));
let _e2848 = select(0i, select(select(i32(_e2841), i32(-2147483648), (_e2841 < -2147483600f)), 2147483647i, (_e2841 > 2147483500f)), (_e2841 == _e2841));
let _e2852 = (_e2848 - select(0i, 1i, (_e2841 < f32(_e2848))));
let _e2856 = global_1.member.member_6.member_7;
let _e2860 = global_1.member.member_6.member_8;
let _e2868 = (select(0i, select(select(i32(_e2792), i32(-2147483648), (_e2792 < -2147483600f)), 2147483647i, (_e2792 > 2147483500f)), (_e2792 == _e2792)) - 1i);
let _e2871 = (_e2837 + 1i);
let _e2881 = (select(0i, select(select(i32(_e2802), i32(-2147483648), (_e2802 < -2147483600f)), 2147483647i, (_e2802 > 2147483500f)), (_e2802 == _e2802)) - 1i);
let _e2884 = (_e2852 + 1i);
let _e2893 = select(0i, select(select(i32(_e2782), i32(-2147483648), (_e2782 < -2147483600f)), 2147483647i, (_e2782 > 2147483500f)), (_e2782 == _e2782));
let _e2894 = (_e2893 - 1i);
let _e2895 = (_e2822 - 1i);
let _e2897 = select(0i, _e2895, (_e2895 > 0i));
let _e2899 = select(0i, _e2822, (_e2822 > 0i));
let _e2900 = (_e2822 + 1i);
let _e2902 = select(_e2894, _e2900, (_e2900 < _e2894));
let _e2903 = (_e2822 + 2i);
let _e2906 = (_e2893 - 2i);
let _e2908 = select(0i, _e2906, (_e2906 > 0i));
let _e2910 = select(_e2908, _e2897, (_e2897 < _e2908));
let _e2912 = select(_e2908, _e2899, (_e2899 < _e2908));
let _e2914 = select(_e2908, _e2902, (_e2902 < _e2908));
let _e2933 = (select(0i, _e2837, (_e2837 > 0i)) * _e2856);
let _e2934 = (select(_e2868, _e2871, (_e2871 < _e2868)) * _e2856);
let _e2935 = (select(0i, _e2852, (_e2852 > 0i)) * _e2860);
let _e2936 = (select(_e2881, _e2884, (_e2884 < _e2881)) * _e2860);
local = type_28(array<i32, 4>(_e2910, _e2912, _e2914, 0i), array<u32, 6>(bitcast<u32>(((_e2897 - _e2910) * 16i)), bitcast<u32>(((_e2899 - _e2910) * 16i)), bitcast<u32>(((_e2899 - _e2912) * 16i)), bitcast<u32>(((_e2902 - _e2912) * 16i)), bitcast<u32>(((_e2902 - _e2914) * 16i)), bitcast<u32>(((select(_e2894, _e2903, (_e2903 < _e2894)) - _e2914) * 16i))));
local_1 = vec3<f32>((_e2787 - f32(_e2822)), (_e2797 - f32(_e2837)), (_e2807 - f32(_e2852)));
let _e2951 = local.member[1u];
let _e2952 = ((_e2935 + _e2933) + _e2951);
let _e2954 = (_e2952 >> bitcast<u32>(1i));
let _e2957 = bitcast<u32>(((_e2952 & 1i) * 16i));
let _e2959 = (bitcast<i32>(_e86) - 1i);
let _e2961 = select(_e2959, _e2954, (_e2954 < _e2959));
let _e2966 = global_2.member[bitcast<u32>(select(0i, _e2961, (_e2961 > 0i)))];
let _e2970 = (_e2954 + 1i);
let _e2972 = select(_e2959, _e2970, (_e2970 < _e2959));
let _e2977 = global_2.member[bitcast<u32>(select(0i, _e2972, (_e2972 > 0i)))];
let _e2984 = ((_e2966 >> bitcast<u32>((_e2957 & 31u))) | ((_e2977 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2957) & 31u))));
let _e2987 = local.member_1[2u];
let _e2993 = f32(bitcast<i32>(((_e2984 >> bitcast<u32>((_e2987 & 31u))) & 65535u)));
let _e2996 = local.member_1[3u];
let _e3003 = local_1[0u];
let _e3006 = (_e2993 + ((f32(bitcast<i32>(((_e2984 >> bitcast<u32>((_e2996 & 31u))) & 65535u))) - _e2993) * _e3003));
let _e3008 = local.member[1u];
let _e3009 = ((_e2935 + _e2934) + _e3008);
let _e3011 = (_e3009 >> bitcast<u32>(1i));
let _e3014 = bitcast<u32>(((_e3009 & 1i) * 16i));
let _e3016 = select(_e2959, _e3011, (_e3011 < _e2959));
let _e3021 = global_2.member[bitcast<u32>(select(0i, _e3016, (_e3016 > 0i)))];
let _e3025 = (_e3011 + 1i);
let _e3027 = select(_e2959, _e3025, (_e3025 < _e2959));
let _e3032 = global_2.member[bitcast<u32>(select(0i, _e3027, (_e3027 > 0i)))];
let _e3039 = ((_e3021 >> bitcast<u32>((_e3014 & 31u))) | ((_e3032 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3014) & 31u))));
let _e3040 = local.member_1[2u];
let _e3046 = f32(bitcast<i32>(((_e3039 >> bitcast<u32>((_e3040 & 31u))) & 65535u)));
let _e3047 = local.member_1[3u];
let _e3054 = local_1[0u];
let _e3059 = local_1[1u];
let _e3062 = (_e3006 + (((_e3046 + ((f32(bitcast<i32>(((_e3039 >> bitcast<u32>((_e3047 & 31u))) & 65535u))) - _e3046) * _e3054)) - _e3006) * _e3059));
let _e3064 = local.member[1u];
let _e3065 = ((_e2936 + _e2933) + _e3064);
let _e3067 = (_e3065 >> bitcast<u32>(1i));
let _e3070 = bitcast<u32>(((_e3065 & 1i) * 16i));
let _e3072 = select(_e2959, _e3067, (_e3067 < _e2959));
let _e3077 = global_2.member[bitcast<u32>(select(0i, _e3072, (_e3072 > 0i)))];
let _e3081 = (_e3067 + 1i);
let _e3083 = select(_e2959, _e3081, (_e3081 < _e2959));
let _e3088 = global_2.member[bitcast<u32>(select(0i, _e3083, (_e3083 > 0i)))];
let _e3095 = ((_e3077 >> bitcast<u32>((_e3070 & 31u))) | ((_e3088 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3070) & 31u))));
let _e3096 = local.member_1[2u];
let _e3102 = f32(bitcast<i32>(((_e3095 >> bitcast<u32>((_e3096 & 31u))) & 65535u)));
let _e3103 = local.member_1[3u];
let _e3110 = local_1[0u];
let _e3113 = (_e3102 + ((f32(bitcast<i32>(((_e3095 >> bitcast<u32>((_e3103 & 31u))) & 65535u))) - _e3102) * _e3110));
let _e3115 = local.member[1u];
let _e3116 = ((_e2936 + _e2934) + _e3115);
let _e3118 = (_e3116 >> bitcast<u32>(1i));
let _e3121 = bitcast<u32>(((_e3116 & 1i) * 16i));
let _e3123 = select(_e2959, _e3118, (_e3118 < _e2959));
let _e3128 = global_2.member[bitcast<u32>(select(0i, _e3123, (_e3123 > 0i)))];
let _e3132 = (_e3118 + 1i);
let _e3134 = select(_e2959, _e3132, (_e3132 < _e2959));
let _e3139 = global_2.member[bitcast<u32>(select(0i, _e3134, (_e3134 > 0i)))];
let _e3146 = ((_e3128 >> bitcast<u32>((_e3121 & 31u))) | ((_e3139 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3121) & 31u))));
let _e3147 = local.member_1[2u];
let _e3153 = f32(bitcast<i32>(((_e3146 >> bitcast<u32>((_e3147 & 31u))) & 65535u)));
let _e3154 = local.member_1[3u];
let _e3161 = local_1[0u];
let _e3165 = local_1[1u];
let _e3170 = local_1[2u];
let _e3177 = global_1.member.member_6.member_5;
let _e3182 = global_1.member.member_6.member_6;
let _e3183 = (((_e3062 + (((_e3113 + (((_e3153 + ((f32(bitcast<i32>(((_e3146 >> bitcast<u32>((_e3154 & 31u))) & 65535u))) - _e3153) * _e3161)) - _e3113) * _e3165)) - _e3062) * _e3170)) * _e3177) + _e3182);
let _e3185 = select(0f, _e3183, (_e3183 > 0f));
let _e3187 = select(1f, _e3185, (_e3185 < 1f));
let _e3190 = global_1.member.member_1;
if ((_e3190 & 16u) == 0u) {
phi_5346_ = type_5(1f, 1f, 1f);
} else {
let _e3196 = global_1.member.member_14.member;
let _e3207 = ((((_e3196.member.member * _e621) + (_e3196.member.member_1 * _e634)) + (_e3196.member.member_2 * _e599)) + _e3196.member_1);
let _e3213 = ((((_e3196.member.member * _e644) + (_e3196.member.member_1 * _e649)) + (_e3196.member.member_2 * _e638)) + _e3196.member_1);
let _e3215 = select(_e3213, _e3207, (_e3207 < _e3213));
let _e3217 = select(_e3213, _e3207, (_e3207 > _e3213));
let _e3219 = (_e3217 - _e3215);
let _e3222 = (-(_e3215) / select(1e-30f, _e3219, (_e3219 > 1e-30f)));
let _e3224 = select(0f, _e3222, (_e3222 > 0f));
let _e3230 = select(select(select(1f, _e3224, (_e3224 < 1f)), 1f, (_e3217 <= 0f)), 0f, (_e3215 > 0f));
let _e3235 = global_1.member.member_14.member_1;
let _e3236 = (_e3235 != 0u);
let _e3246 = global_1.member.member_15.member;
let _e3257 = ((((_e3246.member.member * _e621) + (_e3246.member.member_1 * _e634)) + (_e3246.member.member_2 * _e599)) + _e3246.member_1);
let _e3263 = ((((_e3246.member.member * _e644) + (_e3246.member.member_1 * _e649)) + (_e3246.member.member_2 * _e638)) + _e3246.member_1);
let _e3265 = select(_e3263, _e3257, (_e3257 < _e3263));
let _e3267 = select(_e3263, _e3257, (_e3257 > _e3263));
let _e3269 = (_e3267 - _e3265);
let _e3272 = (-(_e3265) / select(1e-30f, _e3269, (_e3269 > 1e-30f)));
let _e3274 = select(0f, _e3272, (_e3272 > 0f));
let _e3280 = select(select(select(1f, _e3274, (_e3274 < 1f)), 1f, (_e3267 <= 0f)), 0f, (_e3265 > 0f));
let _e3285 = global_1.member.member_15.member_1;
let _e3286 = (_e3285 != 0u);
let _e3296 = global_1.member.member_16.member;
let _e3307 = ((((_e3296.member.member * _e621) + (_e3296.member.member_1 * _e634)) + (_e3296.member.member_2 * _e599)) + _e3296.member_1);
let _e3313 = ((((_e3296.member.member * _e644) + (_e3296.member.member_1 * _e649)) + (_e3296.member.member_2 * _e638)) + _e3296.member_1);
let _e3315 = select(_e3313, _e3307, (_e3307 < _e3313));
let _e3317 = select(_e3313, _e3307, (_e3307 > _e3313));
let _e3319 = (_e3317 - _e3315);
let _e3322 = (-(_e3315) / select(1e-30f, _e3319, (_e3319 > 1e-30f)));
let _e3324 = select(0f, _e3322, (_e3322 > 0f));
let _e3330 = select(select(select(1f, _e3324, (_e3324 < 1f)), 1f, (_e3317 <= 0f)), 0f, (_e3315 > 0f));
let _e3335 = global_1.member.member_16.member_1;
let _e3336 = (_e3335 != 0u);
let _e3346 = global_1.member.member_17.member;
let _e3357 = ((((_e3346.member.member * _e621) + (_e3346.member.member_1 * _e634)) + (_e3346.member.member_2 * _e599)) + _e3346.member_1);
let _e3363 = ((((_e3346.member.member * _e644) + (_e3346.member.member_1 * _e649)) + (_e3346.member.member_2 * _e638)) + _e3346.member_1);
let _e3365 = select(_e3363, _e3357, (_e3357 < _e3363));
let _e3367 = select(_e3363, _e3357, (_e3357 > _e3363));
let _e3369 = (_e3367 - _e3365);
let _e3372 = (-(_e3365) / select(1e-30f, _e3369, (_e3369 > 1e-30f)));
let _e3374 = select(0f, _e3372, (_e3372 > 0f));
let _e3380 = select(select(select(1f, _e3374, (_e3374 < 1f)), 1f, (_e3367 <= 0f)), 0f, (_e3365 > 0f));
let _e3385 = global_1.member.member_17.member_1;
let _e3386 = (_e3385 != 0u);
phi_5346_ = type_5(((((1f * _e3230) * _e3280) * _e3330) * _e3380), ((((1f * select(1f, _e3230, _e3236)) * select(1f, _e3280, _e3286)) * select(1f, _e3330, _e3336)) * select(1f, _e3380, _e3386)), ((((1f * select(1f, 0f, (_e3236 && (_e3213 > 0f)))) * select(1f, 0f, (_e3286 && (_e3263 > 0f)))) * select(1f, 0f, (_e3336 && (_e3313 > 0f)))) * select(1f, 0f, (_e3386 && (_e3363 > 0f)))));
}
let _e3395 = phi_5346_;
let _e3396 = (_e700 - _e664);
let _e3400 = (bitcast<f32>((bitcast<u32>(_e3396) & 2147483647u)) < 1e-12f);
let _e3402 = (1f / select(_e3396, 1f, _e3400));
let _e3404 = ((-0.5f - _e664) * _e3402);
let _e3406 = ((_e2783 - _e664) * _e3402);
let _e3412 = select(_e3406, _e3404, (_e3404 < _e3406));
let _e3414 = select(0f, _e3412, (_e3412 > 0f));
let _e3417 = select(select(1f, _e3414, (_e3414 < 1f)), select(2f, 0f, ((_e664 >= -0.5f) && (_e664 <= _e2783))), _e3400);
let _e3419 = select(_e3406, _e3404, (_e3404 > _e3406));
let _e3421 = select(0f, _e3419, (_e3419 > 0f));
let _e3424 = select(select(1f, _e3421, (_e3421 < 1f)), 1f, _e3400);
let _e3425 = (_e706 - _e679);
let _e3429 = (bitcast<f32>((bitcast<u32>(_e3425) & 2147483647u)) < 1e-12f);
let _e3431 = (1f / select(_e3425, 1f, _e3429));
let _e3433 = ((-0.5f - _e679) * _e3431);
let _e3435 = ((_e2793 - _e679) * _e3431);
let _e3441 = select(_e3435, _e3433, (_e3433 < _e3435));
let _e3443 = select(0f, _e3441, (_e3441 > 0f));
let _e3446 = select(select(1f, _e3443, (_e3443 < 1f)), select(2f, 0f, ((_e679 >= -0.5f) && (_e679 <= _e2793))), _e3429);
let _e3448 = select(_e3435, _e3433, (_e3433 > _e3435));
let _e3450 = select(0f, _e3448, (_e3448 > 0f));
let _e3453 = select(select(1f, _e3450, (_e3450 < 1f)), 1f, _e3429);
let _e3454 = (_e712 - _e694);
let _e3458 = (bitcast<f32>((bitcast<u32>(_e3454) & 2147483647u)) < 1e-12f);
let _e3460 = (1f / select(_e3454, 1f, _e3458));
let _e3462 = ((-0.5f - _e694) * _e3460);
let _e3464 = ((_e2803 - _e694) * _e3460);
let _e3470 = select(_e3464, _e3462, (_e3462 < _e3464));
let _e3472 = select(0f, _e3470, (_e3470 > 0f));
let _e3475 = select(select(1f, _e3472, (_e3472 < 1f)), select(2f, 0f, ((_e694 >= -0.5f) && (_e694 <= _e2803))), _e3458);
let _e3477 = select(_e3464, _e3462, (_e3462 > _e3464));
let _e3479 = select(0f, _e3477, (_e3477 > 0f));
let _e3482 = select(select(1f, _e3479, (_e3479 < 1f)), 1f, _e3458);
let _e3484 = select(_e3453, _e3424, (_e3424 < _e3453));
let _e3488 = select(_e3446, _e3417, (_e3417 > _e3446));
let _e3491 = (select(_e3482, _e3484, (_e3484 < _e3482)) - select(_e3475, _e3488, (_e3488 > _e3475)));
let _e3494 = (_e644 - _e621);
let _e3495 = (_e649 - _e634);
let _e3496 = (_e638 - _e599);
let _e3501 = (((_e3494 * _e3494) + (_e3495 * _e3495)) + (_e3496 * _e3496));
let _e3509 = global_1.member.member_5.member_3;
let _e3510 = ((sqrt(select(0f, _e3501, (_e3501 > 0f))) * select(0f, _e3491, (_e3491 > 0f))) * _e3509);
if (_e100.member_2 >= 3u) {
let _e3513 = (_e3187 * 255f);
let _e3514 = (_e2777.member * 255f);
let _e3515 = (255f - 1f);
let _e3517 = select(0f, _e3513, (_e3513 > 0f));
let _e3519 = select(_e3515, _e3517, (_e3517 < _e3515));
let _e3526 = select(0i, select(select(i32(_e3519), i32(-2147483648), (_e3519 < -2147483600f)), 2147483647i, (_e3519 > 2147483500f)), (_e3519 == _e3519));
let _e3530 = (_e3526 - select(0i, 1i, (_e3519 < f32(_e3526))));
let _e3532 = select(0f, _e3514, (_e3514 > 0f));
let _e3534 = select(_e3515, _e3532, (_e3532 < _e3515));
let _e3541 = select(0i, select(select(i32(_e3534), i32(-2147483648), (_e3534 < -2147483600f)), 2147483647i, (_e3534 > 2147483500f)), (_e3534 == _e3534));
let _e3545 = (_e3541 - select(0i, 1i, (_e3534 < f32(_e3541))));
let _e3548 = (((_e3530 * 256i) + _e3545) * 4i);
let _e3552 = (_e3514 - f32(_e3545));
let _e3554 = (bitcast<i32>(_e90) - 1i);
let _e3556 = select(_e3554, _e3548, (_e3548 < _e3554));
let _e3562 = global_4.member[bitcast<u32>(select(0i, _e3556, (_e3556 > 0i)))];
let _e3563 = (_e3548 + 4i);
let _e3565 = select(_e3554, _e3563, (_e3563 < _e3554));
let _e3571 = global_4.member[bitcast<u32>(select(0i, _e3565, (_e3565 > 0i)))];
let _e3572 = (_e3548 + 1024i);
let _e3574 = select(_e3554, _e3572, (_e3572 < _e3554));
let _e3580 = global_4.member[bitcast<u32>(select(0i, _e3574, (_e3574 > 0i)))];
let _e3581 = (_e3548 + 1028i);
let _e3583 = select(_e3554, _e3581, (_e3581 < _e3554));
let _e3589 = global_4.member[bitcast<u32>(select(0i, _e3583, (_e3583 > 0i)))];
let _e3594 = (bitcast<f32>(((_e3562 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3602 = (_e3594 + (((bitcast<f32>(((_e3571 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3594) * _e3552));
let _e3607 = (bitcast<f32>(((_e3580 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3618 = (_e3602 + (((_e3607 + (((bitcast<f32>(((_e3589 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3607) * _e3552)) - _e3602) * (_e3513 - f32(_e3530))));
let _e3622 = -((_e3618 * (_e3510 * _e3395.member)));
let _e3624 = select(-87f, _e3622, (_e3622 > -87f));
let _e3626 = select(88f, _e3624, (_e3624 < 88f));
let _e3628 = ((_e3626 * 1.442695f) + 0.5f);
let _e3630 = select(-127f, _e3628, (_e3628 > -127f));
let _e3632 = select(128f, _e3630, (_e3630 < 128f));
let _e3639 = select(0i, select(select(i32(_e3632), i32(-2147483648), (_e3632 < -2147483600f)), 2147483647i, (_e3632 > 2147483500f)), (_e3632 == _e3632));
let _e3643 = (_e3639 - select(0i, 1i, (_e3632 < f32(_e3639))));
let _e3644 = f32(_e3643);
let _e3648 = ((_e3626 - (_e3644 * 0.6933594f)) - (_e3644 * -2.1219444e-4f));
let _e3668 = ((1f + (_e3648 * (1f + (_e3648 * (0.5f + (_e3648 * (0.16666667f + (_e3648 * (0.041666668f + (_e3648 * (0.008333334f + (_e3648 * (0.001388889f + (_e3648 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3643 + 127i)) << bitcast<u32>(23i))));
let _e3669 = (1f - _e3668);
phi_6456_ = type_31(_e3668, _e3669, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3669 / select(1e-12f, _e3618, (_e3618 > 1e-12f))))));
} else {
let _e3677 = (_e3187 * 255f);
let _e3678 = (_e2777.member * 255f);
let _e3679 = (255f - 1f);
let _e3681 = select(0f, _e3677, (_e3677 > 0f));
let _e3683 = select(_e3679, _e3681, (_e3681 < _e3679));
let _e3690 = select(0i, select(select(i32(_e3683), i32(-2147483648), (_e3683 < -2147483600f)), 2147483647i, (_e3683 > 2147483500f)), (_e3683 == _e3683));
let _e3694 = (_e3690 - select(0i, 1i, (_e3683 < f32(_e3690))));
let _e3696 = select(0f, _e3678, (_e3678 > 0f));
let _e3698 = select(_e3679, _e3696, (_e3696 < _e3679));
let _e3705 = select(0i, select(select(i32(_e3698), i32(-2147483648), (_e3698 < -2147483600f)), 2147483647i, (_e3698 > 2147483500f)), (_e3698 == _e3698));
let _e3709 = (_e3705 - select(0i, 1i, (_e3698 < f32(_e3705))));
let _e3712 = (((_e3694 * 256i) + _e3709) * 4i);
let _e3714 = (_e3677 - f32(_e3694));
let _e3716 = (_e3678 - f32(_e3709));
let _e3718 = (bitcast<i32>(_e90) - 1i);
let _e3720 = select(_e3718, _e3712, (_e3712 < _e3718));
let _e3726 = global_4.member[bitcast<u32>(select(0i, _e3720, (_e3720 > 0i)))];
let _e3727 = (_e3712 + 4i);
let _e3729 = select(_e3718, _e3727, (_e3727 < _e3718));
let _e3735 = global_4.member[bitcast<u32>(select(0i, _e3729, (_e3729 > 0i)))];
let _e3736 = (_e3712 + 1024i);
let _e3738 = select(_e3718, _e3736, (_e3736 < _e3718));
let _e3744 = global_4.member[bitcast<u32>(select(0i, _e3738, (_e3738 > 0i)))];
let _e3745 = (_e3712 + 1028i);
let _e3747 = select(_e3718, _e3745, (_e3745 < _e3718));
let _e3753 = global_4.member[bitcast<u32>(select(0i, _e3747, (_e3747 > 0i)))];
let _e3758 = (bitcast<f32>(((_e3726 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3766 = (_e3758 + (((bitcast<f32>(((_e3735 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3758) * _e3716));
let _e3771 = (bitcast<f32>(((_e3744 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3782 = (_e3766 + (((_e3771 + (((bitcast<f32>(((_e3753 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3771) * _e3716)) - _e3766) * _e3714));
let _e3795 = (bitcast<f32>((((_e3726 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3803 = (_e3795 + (((bitcast<f32>((((_e3735 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3795) * _e3716));
let _e3808 = (bitcast<f32>((((_e3744 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3820 = (_e3712 + 1i);
let _e3822 = select(_e3718, _e3820, (_e3820 < _e3718));
let _e3828 = global_4.member[bitcast<u32>(select(0i, _e3822, (_e3822 > 0i)))];
let _e3829 = (_e3712 + 5i);
let _e3831 = select(_e3718, _e3829, (_e3829 < _e3718));
let _e3837 = global_4.member[bitcast<u32>(select(0i, _e3831, (_e3831 > 0i)))];
let _e3838 = (_e3712 + 1025i);
let _e3840 = select(_e3718, _e3838, (_e3838 < _e3718));
let _e3846 = global_4.member[bitcast<u32>(select(0i, _e3840, (_e3840 > 0i)))];
let _e3847 = (_e3712 + 1029i);
let _e3849 = select(_e3718, _e3847, (_e3847 < _e3718));
let _e3855 = global_4.member[bitcast<u32>(select(0i, _e3849, (_e3849 > 0i)))];
let _e3860 = (bitcast<f32>(((_e3828 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3868 = (_e3860 + (((bitcast<f32>(((_e3837 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3860) * _e3716));
let _e3873 = (bitcast<f32>(((_e3846 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3897 = (bitcast<f32>((((_e3828 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3905 = (_e3897 + (((bitcast<f32>((((_e3837 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3897) * _e3716));
let _e3910 = (bitcast<f32>((((_e3846 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3925 = (_e3510 * _e3395.member_1);
let _e3927 = -(((_e3803 + (((_e3808 + (((bitcast<f32>((((_e3753 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3808) * _e3716)) - _e3803) * _e3714)) * _e3925));
let _e3929 = select(-87f, _e3927, (_e3927 > -87f));
let _e3931 = select(88f, _e3929, (_e3929 < 88f));
let _e3933 = ((_e3931 * 1.442695f) + 0.5f);
let _e3935 = select(-127f, _e3933, (_e3933 > -127f));
let _e3937 = select(128f, _e3935, (_e3935 < 128f));
let _e3944 = select(0i, select(select(i32(_e3937), i32(-2147483648), (_e3937 < -2147483600f)), 2147483647i, (_e3937 > 2147483500f)), (_e3937 == _e3937));
let _e3948 = (_e3944 - select(0i, 1i, (_e3937 < f32(_e3944))));
let _e3949 = f32(_e3948);
let _e3953 = ((_e3931 - (_e3949 * 0.6933594f)) - (_e3949 * -2.1219444e-4f));
let _e3975 = -(((_e3868 + (((_e3873 + (((bitcast<f32>(((_e3855 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3873) * _e3716)) - _e3868) * _e3714)) * _e3925));
let _e3977 = select(-87f, _e3975, (_e3975 > -87f));
let _e3979 = select(88f, _e3977, (_e3977 < 88f));
let _e3981 = ((_e3979 * 1.442695f) + 0.5f);
let _e3983 = select(-127f, _e3981, (_e3981 > -127f));
let _e3985 = select(128f, _e3983, (_e3983 < 128f));
let _e3992 = select(0i, select(select(i32(_e3985), i32(-2147483648), (_e3985 < -2147483600f)), 2147483647i, (_e3985 > 2147483500f)), (_e3985 == _e3985));
let _e3996 = (_e3992 - select(0i, 1i, (_e3985 < f32(_e3992))));
let _e3997 = f32(_e3996);
let _e4001 = ((_e3979 - (_e3997 * 0.6933594f)) - (_e3997 * -2.1219444e-4f));
let _e4023 = -(((_e3905 + (((_e3910 + (((bitcast<f32>((((_e3855 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3910) * _e3716)) - _e3905) * _e3714)) * _e3925));
let _e4025 = select(-87f, _e4023, (_e4023 > -87f));
let _e4027 = select(88f, _e4025, (_e4025 < 88f));
let _e4029 = ((_e4027 * 1.442695f) + 0.5f);
let _e4031 = select(-127f, _e4029, (_e4029 > -127f));
let _e4033 = select(128f, _e4031, (_e4031 < 128f));
let _e4040 = select(0i, select(select(i32(_e4033), i32(-2147483648), (_e4033 < -2147483600f)), 2147483647i, (_e4033 > 2147483500f)), (_e4033 == _e4033));
let _e4044 = (_e4040 - select(0i, 1i, (_e4033 < f32(_e4040))));
let _e4045 = f32(_e4044);
let _e4049 = ((_e4027 - (_e4045 * 0.6933594f)) - (_e4045 * -2.1219444e-4f));
let _e4072 = -((_e3782 * (_e3510 * _e3395.member)));
let _e4074 = select(-87f, _e4072, (_e4072 > -87f));
let _e4076 = select(88f, _e4074, (_e4074 < 88f));
let _e4078 = ((_e4076 * 1.442695f) + 0.5f);
let _e4080 = select(-127f, _e4078, (_e4078 > -127f));
let _e4082 = select(128f, _e4080, (_e4080 < 128f));
let _e4089 = select(0i, select(select(i32(_e4082), i32(-2147483648), (_e4082 < -2147483600f)), 2147483647i, (_e4082 > 2147483500f)), (_e4082 == _e4082));
let _e4093 = (_e4089 - select(0i, 1i, (_e4082 < f32(_e4089))));
let _e4094 = f32(_e4093);
let _e4098 = ((_e4076 - (_e4094 * 0.6933594f)) - (_e4094 * -2.1219444e-4f));
let _e4118 = ((1f + (_e4098 * (1f + (_e4098 * (0.5f + (_e4098 * (0.16666667f + (_e4098 * (0.041666668f + (_e4098 * (0.008333334f + (_e4098 * (0.001388889f + (_e4098 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4093 + 127i)) << bitcast<u32>(23i))));
let _e4119 = (1f - _e4118);
phi_6456_ = type_31(_e4118, _e4119, vec3<f32>(((1f + (_e3953 * (1f + (_e3953 * (0.5f + (_e3953 * (0.16666667f + (_e3953 * (0.041666668f + (_e3953 * (0.008333334f + (_e3953 * (0.001388889f + (_e3953 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3948 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4001 * (1f + (_e4001 * (0.5f + (_e4001 * (0.16666667f + (_e4001 * (0.041666668f + (_e4001 * (0.008333334f + (_e4001 * (0.001388889f + (_e4001 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3996 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4049 * (1f + (_e4049 * (0.5f + (_e4049 * (0.16666667f + (_e4049 * (0.041666668f + (_e4049 * (0.008333334f + (_e4049 * (0.001388889f + (_e4049 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4044 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e4119 / select(1e-12f, _e3782, (_e3782 > 1e-12f))))));
}
let _e4127 = phi_6456_;
if _e717 {
let _e4131 = global_1.member.member_5.member_2;
let _e4139 = global_1.member.member_5.member_4;
let _e4142 = (_e2777.member_3.x * _e3395.member_2);
let _e4144 = (_e2777.member_3.y * _e3395.member_2);
let _e4146 = (_e2777.member_3.z * _e3395.member_2);
let _e4147 = (0.5f * (_e4131 / select(1e-6f, _e180, (_e180 > 1e-6f))));
let _e4151 = (_e158 + (_e4142 * _e4147));
let _e4152 = (_e169 + (_e4144 * _e4147));
let _e4153 = (_e180 + (_e4146 * _e4147));
let _e4155 = (2f * _e4131);
let _e4157 = ((_e4153 * _e4153) + (_e4155 * _e4146));
let _e4161 = (_e4153 + sqrt(select(0f, _e4157, (_e4157 > 0f))));
let _e4165 = (0.5f * (_e4155 / select(1e-6f, _e4161, (_e4161 > 1e-6f))));
let _e4169 = (_e4151 + (_e4142 * _e4165));
let _e4170 = (_e4152 + (_e4144 * _e4165));
let _e4171 = (_e4153 + (_e4146 * _e4165));
let _e4175 = (_e4139 * _e4139);
let _e4177 = (_e4171 * _e4171);
let _e4185 = (((_e4153 <= 0f) || (_e4157 <= 0f)) || ((_e4171 <= 0f) || (_e4177 <= (_e4175 * (((_e4169 * _e4169) + (_e4170 * _e4170)) + _e4177)))));
let _e4199 = (_e158 + ((_e2777.member_4.x * _e3395.member_2) * _e4131));
let _e4200 = (_e169 + ((_e2777.member_4.y * _e3395.member_2) * _e4131));
let _e4201 = (_e180 + ((_e2777.member_4.z * _e3395.member_2) * _e4131));
let _e4203 = (_e4201 * _e4201);
let _e4212 = ((_e3190 & 1u) != 0u);
let _e4216 = select(_e4185, ((_e4201 <= 0f) || (_e4203 <= (_e4175 * (((_e4199 * _e4199) + (_e4200 * _e4200)) + _e4203)))), _e4212);
phi_6608_ = vec3<f32>(select(select(select(_e4169, _e4151, _e4185), _e4199, _e4212), _e158, _e4216), select(select(select(_e4170, _e4152, _e4185), _e4200, _e4212), _e169, _e4216), select(select(select(_e4171, _e4153, _e4185), _e4201, _e4212), _e180, _e4216));
phi_6609_ = select(1f, 0f, _e4216);
} else {
phi_6608_ = vec3<f32>(_e158, _e169, _e180);
phi_6609_ = 1f;
}
let _e4223 = phi_6608_;
let _e4225 = phi_6609_;
let _e4228 = (_e4127.member * _e4225);
global_5.member[_e115] = (_e126 * (_e4127.member_2.x * _e4228));
global_5.member[_e127] = (_e136 * (_e4127.member_2.y * _e4228));
global_5.member[_e138] = (_e147 * (_e4127.member_2.z * _e4228));
global_5.member[_e149] = _e4223.x;
global_5.member[_e160] = _e4223.y;
global_5.member[_e171] = _e4223.z;
global_5.member[_e182] = _e191;
global_5.member[_e193] = _e202;
global_5.member[_e204] = _e213;
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
