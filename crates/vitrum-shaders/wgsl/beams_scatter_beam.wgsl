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
member_8: u32,
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
member: i32,
member_1: i32,
}
struct type_26 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(4)
var<storage> global_5: type_13;
@group(0) @binding(5)
var<storage, read_write> global_6: type_26;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var local_46: i32;
var local_47: i32;
var local_48: i32;
var local_49: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var local_62: i32;
var local_63: i32;
var local_64: i32;
var local_65: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var local_69: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var local_75: i32;
var local_76: i32;
var local_77: i32;
var phi_387_: bool;
var phi_388_: bool;
var phi_389_: bool;
var phi_769_: type_23;
var phi_1478_: f32;
var phi_1481_: u32;
var phi_1479_: f32;
var phi_1482_: u32;
var local_78: u32;
var phi_1511_: f32;
var phi_1514_: u32;
var phi_1512_: f32;
var phi_1515_: u32;
var phi_1526_: u32;
var phi_1581_: f32;
var phi_1584_: u32;
var phi_1582_: f32;
var phi_1585_: u32;
var local_79: u32;
var phi_1614_: f32;
var phi_1617_: u32;
var phi_1615_: f32;
var phi_1618_: u32;
var phi_1629_: u32;
var phi_1630_: u32;
var phi_1685_: f32;
var phi_1688_: u32;
var phi_1686_: f32;
var phi_1689_: u32;
var local_80: u32;
var phi_1718_: f32;
var phi_1721_: u32;
var phi_1719_: f32;
var phi_1722_: u32;
var phi_1733_: u32;
var phi_1734_: u32;
var phi_1770_: type_23;
var phi_1845_: i32;
var phi_1883_: i32;
var phi_2037_: i32;
var phi_2142_: type_23;
var phi_2662_: type_23;
var phi_2895_: u32;
var phi_2925_: u32;
var phi_2955_: u32;
var phi_2038_: i32;
var phi_1884_: i32;
var phi_3004_: i32;
var phi_3158_: i32;
var phi_3263_: type_23;
var phi_3809_: type_23;
var phi_3887_: i32;
var phi_3898_: i32;
var phi_3926_: type_23;
var phi_3975_: u32;
var phi_3976_: u32;
var phi_3977_: u32;
var phi_4394_: i32;
var phi_4405_: i32;
var phi_4433_: type_23;
var phi_4482_: u32;
var phi_4483_: u32;
var phi_4484_: u32;
var phi_4901_: i32;
var phi_4912_: i32;
var phi_4940_: type_23;
var phi_4989_: u32;
var phi_4990_: u32;
var phi_4991_: u32;
var phi_5408_: i32;
var phi_5419_: i32;
var phi_5447_: type_23;
var phi_5496_: u32;
var phi_5497_: u32;
var phi_5498_: u32;
var phi_5924_: type_23;
var phi_6157_: u32;
var phi_6187_: u32;
var phi_6217_: u32;
var phi_3159_: i32;
var phi_3005_: i32;
var phi_6262_: i32;
var phi_6416_: i32;
var phi_6521_: type_23;
var phi_7065_: type_23;
var phi_7143_: i32;
var phi_7154_: i32;
var phi_7182_: type_23;
var phi_7231_: u32;
var phi_7232_: u32;
var phi_7233_: u32;
var phi_7650_: i32;
var phi_7661_: i32;
var phi_7689_: type_23;
var phi_7738_: u32;
var phi_7739_: u32;
var phi_7740_: u32;
var phi_8157_: i32;
var phi_8168_: i32;
var phi_8196_: type_23;
var phi_8245_: u32;
var phi_8246_: u32;
var phi_8247_: u32;
var phi_8664_: i32;
var phi_8675_: i32;
var phi_8703_: type_23;
var phi_8752_: u32;
var phi_8753_: u32;
var phi_8754_: u32;
var phi_9189_: type_23;
var phi_9267_: i32;
var phi_9278_: i32;
var phi_9306_: type_23;
var phi_9355_: u32;
var phi_9356_: u32;
var phi_9357_: u32;
var phi_9774_: i32;
var phi_9785_: i32;
var phi_9813_: type_23;
var phi_9862_: u32;
var phi_9863_: u32;
var phi_9864_: u32;
var phi_10281_: i32;
var phi_10292_: i32;
var phi_10320_: type_23;
var phi_10369_: u32;
var phi_10370_: u32;
var phi_10371_: u32;
var phi_10788_: i32;
var phi_10799_: i32;
var phi_10827_: type_23;
var phi_10876_: u32;
var phi_10877_: u32;
var phi_10878_: u32;
var phi_11313_: type_23;
var phi_11391_: i32;
var phi_11402_: i32;
var phi_11430_: type_23;
var phi_11479_: u32;
var phi_11480_: u32;
var phi_11481_: u32;
var phi_11898_: i32;
var phi_11909_: i32;
var phi_11937_: type_23;
var phi_11986_: u32;
var phi_11987_: u32;
var phi_11988_: u32;
var phi_12405_: i32;
var phi_12416_: i32;
var phi_12444_: type_23;
var phi_12493_: u32;
var phi_12494_: u32;
var phi_12495_: u32;
var phi_12912_: i32;
var phi_12923_: i32;
var phi_12951_: type_23;
var phi_13000_: u32;
var phi_13001_: u32;
var phi_13002_: u32;
var phi_13428_: type_23;
var phi_13661_: u32;
var phi_13691_: u32;
var phi_13721_: u32;
var phi_6417_: i32;
var phi_6263_: i32;
var phi_13787_: type_23;
var phi_13862_: i32;
var phi_13866_: type_23;
var phi_13869_: i32;
var phi_14020_: type_23;
var phi_14023_: i32;
var phi_14153_: type_23;
var phi_14202_: u32;
var phi_14203_: u32;
var phi_14204_: u32;
var phi_14780_: type_23;
var phi_14977_: u32;
var phi_14978_: u32;
var phi_14979_: u32;
var phi_15013_: u32;
var phi_15043_: u32;
var phi_15073_: u32;
var phi_15110_: type_23;
var phi_14021_: type_23;
var phi_14024_: i32;
var phi_13867_: type_23;
var phi_13870_: i32;
var local_81: type_23;
var local_82: type_23;
var phi_15127_: i32;
var phi_15162_: i32;
var phi_15316_: i32;
var phi_15421_: type_23;
var phi_15941_: type_23;
var phi_16174_: u32;
var phi_16204_: u32;
var phi_16234_: u32;
var phi_15317_: i32;
var phi_15163_: i32;
var phi_16283_: i32;
var phi_16437_: i32;
var phi_16542_: type_23;
var phi_17088_: type_23;
var phi_17166_: i32;
var phi_17177_: i32;
var phi_17205_: type_23;
var phi_17254_: u32;
var phi_17255_: u32;
var phi_17256_: u32;
var phi_17673_: i32;
var phi_17684_: i32;
var phi_17712_: type_23;
var phi_17761_: u32;
var phi_17762_: u32;
var phi_17763_: u32;
var phi_18180_: i32;
var phi_18191_: i32;
var phi_18219_: type_23;
var phi_18268_: u32;
var phi_18269_: u32;
var phi_18270_: u32;
var phi_18687_: i32;
var phi_18698_: i32;
var phi_18726_: type_23;
var phi_18775_: u32;
var phi_18776_: u32;
var phi_18777_: u32;
var phi_19203_: type_23;
var phi_19436_: u32;
var phi_19466_: u32;
var phi_19496_: u32;
var phi_16438_: i32;
var phi_16284_: i32;
var phi_19541_: i32;
var phi_19695_: i32;
var phi_19800_: type_23;
var phi_20344_: type_23;
var phi_20422_: i32;
var phi_20433_: i32;
var phi_20461_: type_23;
var phi_20510_: u32;
var phi_20511_: u32;
var phi_20512_: u32;
var phi_20929_: i32;
var phi_20940_: i32;
var phi_20968_: type_23;
var phi_21017_: u32;
var phi_21018_: u32;
var phi_21019_: u32;
var phi_21436_: i32;
var phi_21447_: i32;
var phi_21475_: type_23;
var phi_21524_: u32;
var phi_21525_: u32;
var phi_21526_: u32;
var phi_21943_: i32;
var phi_21954_: i32;
var phi_21982_: type_23;
var phi_22031_: u32;
var phi_22032_: u32;
var phi_22033_: u32;
var phi_22468_: type_23;
var phi_22546_: i32;
var phi_22557_: i32;
var phi_22585_: type_23;
var phi_22634_: u32;
var phi_22635_: u32;
var phi_22636_: u32;
var phi_23053_: i32;
var phi_23064_: i32;
var phi_23092_: type_23;
var phi_23141_: u32;
var phi_23142_: u32;
var phi_23143_: u32;
var phi_23560_: i32;
var phi_23571_: i32;
var phi_23599_: type_23;
var phi_23648_: u32;
var phi_23649_: u32;
var phi_23650_: u32;
var phi_24067_: i32;
var phi_24078_: i32;
var phi_24106_: type_23;
var phi_24155_: u32;
var phi_24156_: u32;
var phi_24157_: u32;
var phi_24592_: type_23;
var phi_24670_: i32;
var phi_24681_: i32;
var phi_24709_: type_23;
var phi_24758_: u32;
var phi_24759_: u32;
var phi_24760_: u32;
var phi_25177_: i32;
var phi_25188_: i32;
var phi_25216_: type_23;
var phi_25265_: u32;
var phi_25266_: u32;
var phi_25267_: u32;
var phi_25684_: i32;
var phi_25695_: i32;
var phi_25723_: type_23;
var phi_25772_: u32;
var phi_25773_: u32;
var phi_25774_: u32;
var phi_26191_: i32;
var phi_26202_: i32;
var phi_26230_: type_23;
var phi_26279_: u32;
var phi_26280_: u32;
var phi_26281_: u32;
var phi_26707_: type_23;
var phi_26940_: u32;
var phi_26970_: u32;
var phi_27000_: u32;
var phi_19696_: i32;
var phi_19542_: i32;
var local_83: u32;
var local_84: u32;
var local_85: u32;
var local_86: u32;
var local_87: u32;
var local_88: u32;
var local_89: type_23;
let _e128 = global;
let _e138 = arrayLength((&global_4.member));
let _e141 = arrayLength((&global_5.member));
let _e143 = arrayLength((&global_6.member));
let _e146 = global_1.member.member;
if (_e128.x < _e146.member) {
if (_e128.y < _e146.member_1) {
let _e154 = bitcast<i32>(_e128.x);
let _e158 = global_1.member.member.member;
let _e159 = bitcast<i32>(_e158);
let _e163 = global_1.member.member_12.member_4;
let _e167 = global_1.member.member_12.member_6;
let _e169 = bitcast<i32>((_e163 * _e167));
let _e171 = bitcast<i32>((_e128.y * 16u));
local_75 = _e169;
local_76 = _e154;
local_77 = _e159;
let _e172 = local_75;
let _e173 = local_77;
let _e176 = local_76;
let _e177 = ((_e172 + (11i * _e173)) + _e176);
let _e179 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e181 = select(_e179, _e177, (_e177 < _e179));
let _e186 = global_3.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e187 = f32(_e171);
if (_e186 < _e187) {
phi_388_ = bool();
phi_389_ = true;
} else {
let _e189 = local_75;
let _e190 = local_77;
let _e193 = local_76;
let _e194 = ((_e189 + (10i * _e190)) + _e193);
let _e196 = select(_e179, _e194, (_e194 < _e179));
let _e201 = global_3.member[bitcast<u32>(select(0i, _e196, (_e196 > 0i)))];
let _e204 = (_e201 > f32((_e171 + 15i)));
if _e204 {
phi_387_ = bool();
} else {
let _e205 = local_75;
let _e206 = local_77;
let _e209 = local_76;
let _e210 = ((_e205 + (11i * _e206)) + _e209);
let _e212 = select(_e179, _e210, (_e210 < _e179));
let _e217 = global_3.member[bitcast<u32>(select(0i, _e212, (_e212 > 0i)))];
phi_387_ = (_e201 <= _e217);
}
let _e220 = phi_387_;
phi_388_ = _e220;
phi_389_ = _e204;
}
let _e222 = phi_388_;
let _e224 = phi_389_;
if select(_e222, false, _e224) {
local_72 = _e169;
local_73 = _e154;
local_74 = _e159;
let _e226 = local_72;
let _e227 = local_74;
let _e230 = local_73;
let _e231 = ((_e226 + (10i * _e227)) + _e230);
let _e233 = select(_e179, _e231, (_e231 < _e179));
let _e238 = global_3.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e239 = local_72;
let _e240 = local_74;
let _e243 = local_73;
let _e244 = ((_e239 + (11i * _e240)) + _e243);
let _e246 = select(_e179, _e244, (_e244 < _e179));
let _e251 = global_3.member[bitcast<u32>(select(0i, _e246, (_e246 > 0i)))];
let _e252 = local_72;
let _e253 = local_74;
let _e256 = local_73;
let _e257 = ((_e252 + (12i * _e253)) + _e256);
let _e259 = select(_e179, _e257, (_e257 < _e179));
let _e264 = global_3.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e265 = local_72;
let _e266 = local_74;
let _e269 = local_73;
let _e270 = ((_e265 + (13i * _e266)) + _e269);
let _e272 = select(_e179, _e270, (_e270 < _e179));
let _e277 = global_3.member[bitcast<u32>(select(0i, _e272, (_e272 > 0i)))];
local_69 = _e169;
local_70 = _e154;
local_71 = _e159;
let _e278 = local_69;
let _e279 = local_71;
let _e281 = local_70;
let _e282 = ((_e278 + _e279) + _e281);
let _e284 = select(_e179, _e282, (_e282 < _e179));
let _e289 = global_3.member[bitcast<u32>(select(0i, _e284, (_e284 > 0i)))];
let _e290 = local_69;
let _e291 = local_71;
let _e294 = local_70;
let _e295 = ((_e290 + (2i * _e291)) + _e294);
let _e297 = select(_e179, _e295, (_e295 < _e179));
let _e302 = global_3.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e303 = local_69;
let _e304 = local_71;
let _e307 = local_70;
let _e308 = ((_e303 + (3i * _e304)) + _e307);
let _e310 = select(_e179, _e308, (_e308 < _e179));
let _e315 = global_3.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e316 = local_69;
let _e317 = local_70;
let _e318 = (_e316 + _e317);
let _e320 = select(_e179, _e318, (_e318 < _e179));
let _e325 = global_3.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e326 = (_e325 > 0f);
let _e327 = local_69;
let _e328 = local_71;
let _e331 = local_70;
let _e332 = ((_e327 + (4i * _e328)) + _e331);
let _e334 = select(_e179, _e332, (_e332 < _e179));
let _e339 = global_3.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e340 = local_69;
let _e341 = local_71;
let _e344 = local_70;
let _e345 = ((_e340 + (5i * _e341)) + _e344);
let _e347 = select(_e179, _e345, (_e345 < _e179));
let _e352 = global_3.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e353 = local_69;
let _e354 = local_71;
let _e357 = local_70;
let _e358 = ((_e353 + (6i * _e354)) + _e357);
let _e360 = select(_e179, _e358, (_e358 < _e179));
let _e365 = global_3.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e366 = local_69;
let _e367 = local_71;
let _e370 = local_70;
let _e371 = ((_e366 + (7i * _e367)) + _e370);
let _e373 = select(_e179, _e371, (_e371 < _e179));
let _e378 = global_3.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e379 = local_69;
let _e380 = local_71;
let _e383 = local_70;
let _e384 = ((_e379 + (8i * _e380)) + _e383);
let _e386 = select(_e179, _e384, (_e384 < _e179));
let _e391 = global_3.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e392 = local_69;
let _e393 = local_71;
let _e396 = local_70;
let _e397 = ((_e392 + (9i * _e393)) + _e396);
let _e399 = select(_e179, _e397, (_e397 < _e179));
let _e404 = global_3.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
let _e407 = bitcast<f32>((bitcast<u32>(_e302) & 2147483647u));
let _e411 = global_1.member.member_1.member;
let _e415 = global_1.member.member_1.member_1;
let _e416 = bitcast<i32>(_e411);
let _e417 = bitcast<i32>(_e415);
if _e326 {
phi_769_ = type_23(_e417, _e416);
} else {
phi_769_ = type_23(_e416, _e417);
}
let _e421 = phi_769_;
if ((_e326 != (_e146.member_2 == 1u)) || (_e171 >= _e421.member)) {
} else {
let _e430 = global_1.member.member_12.member_5;
local_66 = bitcast<i32>((_e163 * _e430));
local_67 = _e154;
local_68 = _e159;
let _e433 = local_66;
let _e434 = local_67;
let _e435 = (_e433 + _e434);
let _e437 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e439 = select(_e437, _e435, (_e435 < _e437));
let _e444 = global_2.member[bitcast<u32>(select(0i, _e439, (_e439 > 0i)))];
let _e445 = local_66;
let _e446 = local_68;
let _e448 = local_67;
let _e449 = ((_e445 + _e446) + _e448);
let _e451 = select(_e437, _e449, (_e449 < _e437));
let _e456 = global_2.member[bitcast<u32>(select(0i, _e451, (_e451 > 0i)))];
let _e457 = local_66;
let _e458 = local_68;
let _e461 = local_67;
let _e462 = ((_e457 + (2i * _e458)) + _e461);
let _e464 = select(_e437, _e462, (_e462 < _e437));
let _e469 = global_2.member[bitcast<u32>(select(0i, _e464, (_e464 > 0i)))];
let _e470 = local_66;
let _e471 = local_68;
let _e474 = local_67;
let _e475 = ((_e470 + (3i * _e471)) + _e474);
let _e477 = select(_e437, _e475, (_e475 < _e437));
let _e482 = global_2.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e483 = local_66;
let _e484 = local_68;
let _e487 = local_67;
let _e488 = ((_e483 + (4i * _e484)) + _e487);
let _e490 = select(_e437, _e488, (_e488 < _e437));
let _e495 = global_2.member[bitcast<u32>(select(0i, _e490, (_e490 > 0i)))];
let _e496 = local_66;
let _e497 = local_68;
let _e500 = local_67;
let _e501 = ((_e496 + (5i * _e497)) + _e500);
let _e503 = select(_e437, _e501, (_e501 < _e437));
let _e508 = global_2.member[bitcast<u32>(select(0i, _e503, (_e503 > 0i)))];
let _e509 = local_66;
let _e510 = local_68;
let _e513 = local_67;
let _e514 = ((_e509 + (18i * _e510)) + _e513);
let _e516 = select(_e437, _e514, (_e514 < _e437));
let _e521 = global_2.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e522 = local_66;
let _e523 = local_68;
let _e526 = local_67;
let _e527 = ((_e522 + (19i * _e523)) + _e526);
let _e529 = select(_e437, _e527, (_e527 < _e437));
let _e534 = global_2.member[bitcast<u32>(select(0i, _e529, (_e529 > 0i)))];
let _e535 = local_66;
let _e536 = local_68;
let _e539 = local_67;
let _e540 = ((_e535 + (20i * _e536)) + _e539);
let _e542 = select(_e437, _e540, (_e540 < _e437));
let _e547 = global_2.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e548 = local_66;
let _e549 = local_68;
let _e552 = local_67;
let _e553 = ((_e548 + (23i * _e549)) + _e552);
let _e555 = select(_e437, _e553, (_e553 < _e437));
let _e560 = global_2.member[bitcast<u32>(select(0i, _e555, (_e555 > 0i)))];
let _e561 = (_e171 + 16i);
let _e563 = (0.5f * (16f - 1f));
let _e564 = (_e187 + _e563);
let _e568 = (-(((_e289 * _e564) + _e315)) / _e302);
let _e586 = (0.5f * 1f);
let _e588 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e339 * _e564) + ((_e352 * _e568) + _e365))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e378 * _e564) + ((_e391 * _e568) + _e404))) & 2147483647u)))) / _e407) + _e586));
let _e592 = global_1.member.member_18.member_1;
phi_1478_ = 8f;
phi_1481_ = 0u;
loop {
let _e594 = phi_1478_;
let _e596 = phi_1481_;
local_78 = _e596;
local_83 = _e596;
let _e599 = ((_e596 < _e592) && (_e588 >= _e594));
if _e599 {
phi_1479_ = (_e594 * 2f);
phi_1482_ = (_e596 + 1u);
} else {
phi_1479_ = f32();
phi_1482_ = u32();
}
let _e603 = phi_1479_;
let _e605 = phi_1482_;
continue;
continuing {
phi_1478_ = _e603;
phi_1481_ = _e605;
break if !(_e599);
}
}
let _e608 = local_78;
let _e612 = f32((1i << bitcast<u32>((_e608 & 31u))));
let _e615 = f32(_e561);
if (((_e187 - _e612) > _e264) && ((_e615 + _e612) < _e277)) {
let _e11365 = local_83;
phi_1526_ = _e11365;
} else {
phi_1511_ = 8f;
phi_1514_ = 0u;
loop {
let _e621 = phi_1511_;
let _e623 = phi_1514_;
local_84 = _e623;
let _e626 = ((_e623 < _e592) && ((_e588 * 0.125f) >= _e621));
if _e626 {
phi_1512_ = (_e621 * 2f);
phi_1515_ = (_e623 + 1u);
} else {
phi_1512_ = f32();
phi_1515_ = u32();
}
let _e630 = phi_1512_;
let _e632 = phi_1515_;
continue;
continuing {
phi_1511_ = _e630;
phi_1514_ = _e632;
break if !(_e626);
}
}
let _e11367 = local_84;
phi_1526_ = _e11367;
}
let _e635 = phi_1526_;
let _e636 = (_e171 - 16i);
let _e640 = (_e238 <= _e251);
let _e641 = f32(_e636);
if (((_e636 >= 0i) && (_e636 < _e421.member)) && ((_e640 && (_e251 >= _e641)) && (_e238 <= f32((_e171 - 1i))))) {
let _e649 = (_e641 + _e563);
let _e653 = (-(((_e289 * _e649) + _e315)) / _e302);
let _e672 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e339 * _e649) + ((_e352 * _e653) + _e365))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e378 * _e649) + ((_e391 * _e653) + _e404))) & 2147483647u)))) / _e407) + _e586));
phi_1581_ = 8f;
phi_1584_ = 0u;
loop {
let _e674 = phi_1581_;
let _e676 = phi_1584_;
local_79 = _e676;
local_85 = _e676;
let _e679 = ((_e676 < _e592) && (_e672 >= _e674));
if _e679 {
phi_1582_ = (_e674 * 2f);
phi_1585_ = (_e676 + 1u);
} else {
phi_1582_ = f32();
phi_1585_ = u32();
}
let _e683 = phi_1582_;
let _e685 = phi_1585_;
continue;
continuing {
phi_1581_ = _e683;
phi_1584_ = _e685;
break if !(_e679);
}
}
let _e688 = local_79;
let _e692 = f32((1i << bitcast<u32>((_e688 & 31u))));
if (((_e641 - _e692) > _e264) && ((_e187 + _e692) < _e277)) {
let _e11379 = local_85;
phi_1629_ = _e11379;
} else {
phi_1614_ = 8f;
phi_1617_ = 0u;
loop {
let _e700 = phi_1614_;
let _e702 = phi_1617_;
local_86 = _e702;
let _e705 = ((_e702 < _e592) && ((_e672 * 0.125f) >= _e700));
if _e705 {
phi_1615_ = (_e700 * 2f);
phi_1618_ = (_e702 + 1u);
} else {
phi_1615_ = f32();
phi_1618_ = u32();
}
let _e709 = phi_1615_;
let _e711 = phi_1618_;
continue;
continuing {
phi_1614_ = _e709;
phi_1617_ = _e711;
break if !(_e705);
}
}
let _e11381 = local_86;
phi_1629_ = _e11381;
}
let _e714 = phi_1629_;
phi_1630_ = _e714;
} else {
phi_1630_ = _e635;
}
let _e716 = phi_1630_;
if (((_e561 >= 0i) && (_e561 < _e421.member)) && ((_e640 && (_e251 >= _e615)) && (_e238 <= f32((_e171 + 31i))))) {
let _e728 = (_e615 + _e563);
let _e732 = (-(((_e289 * _e728) + _e315)) / _e302);
let _e751 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e339 * _e728) + ((_e352 * _e732) + _e365))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e378 * _e728) + ((_e391 * _e732) + _e404))) & 2147483647u)))) / _e407) + _e586));
phi_1685_ = 8f;
phi_1688_ = 0u;
loop {
let _e753 = phi_1685_;
let _e755 = phi_1688_;
local_80 = _e755;
local_87 = _e755;
let _e758 = ((_e755 < _e592) && (_e751 >= _e753));
if _e758 {
phi_1686_ = (_e753 * 2f);
phi_1689_ = (_e755 + 1u);
} else {
phi_1686_ = f32();
phi_1689_ = u32();
}
let _e762 = phi_1686_;
let _e764 = phi_1689_;
continue;
continuing {
phi_1685_ = _e762;
phi_1688_ = _e764;
break if !(_e758);
}
}
let _e767 = local_80;
let _e771 = f32((1i << bitcast<u32>((_e767 & 31u))));
if (((_e615 - _e771) > _e264) && ((f32((_e171 + 32i)) + _e771) < _e277)) {
let _e11394 = local_87;
phi_1733_ = _e11394;
} else {
phi_1718_ = 8f;
phi_1721_ = 0u;
loop {
let _e780 = phi_1718_;
let _e782 = phi_1721_;
local_88 = _e782;
let _e785 = ((_e782 < _e592) && ((_e751 * 0.125f) >= _e780));
if _e785 {
phi_1719_ = (_e780 * 2f);
phi_1722_ = (_e782 + 1u);
} else {
phi_1719_ = f32();
phi_1722_ = u32();
}
let _e789 = phi_1719_;
let _e791 = phi_1722_;
continue;
continuing {
phi_1718_ = _e789;
phi_1721_ = _e791;
break if !(_e785);
}
}
let _e11396 = local_88;
phi_1733_ = _e11396;
}
let _e794 = phi_1733_;
phi_1734_ = _e794;
} else {
phi_1734_ = _e635;
}
let _e796 = phi_1734_;
let _e799 = global_1.member.member_1.member;
let _e802 = global_1.member.member_1.member_1;
let _e803 = bitcast<i32>(_e799);
let _e804 = bitcast<i32>(_e802);
if _e326 {
phi_1770_ = type_23(_e804, _e803);
} else {
phi_1770_ = type_23(_e803, _e804);
}
let _e808 = phi_1770_;
let _e812 = f32((_e171 + 15i));
let _e814 = select(_e812, _e251, (_e251 < _e812));
let _e816 = select(_e187, _e814, (_e814 > _e187));
let _e818 = select(_e812, _e816, (_e816 < _e812));
let _e825 = select(0i, select(select(i32(_e818), i32(-2147483648), (_e818 < -2147483600f)), 2147483647i, (_e818 > 2147483500f)), (_e818 == _e818));
let _e829 = (_e825 - select(0i, 1i, (_e818 < f32(_e825))));
let _e830 = bitcast<i32>(_e829);
let _e832 = select(_e187, _e238, (_e238 > _e187));
let _e834 = select(_e187, _e832, (_e832 > _e187));
let _e836 = select(_e812, _e834, (_e834 < _e812));
let _e843 = select(0i, select(select(i32(_e836), i32(-2147483648), (_e836 < -2147483600f)), 2147483647i, (_e836 > 2147483500f)), (_e836 == _e836));
let _e847 = (_e843 - select(0i, 1i, (_e836 < f32(_e843))));
let _e848 = bitcast<i32>(_e847);
if (_e830 < _e808.member) {
phi_1845_ = _e830;
} else {
phi_1845_ = (_e808.member - 1i);
}
let _e852 = phi_1845_;
let _e853 = (_e808.member_1 - 1i);
let _e854 = (_e635 == 0u);
if _e854 {
let _e856 = select(_e716, 0u, (_e716 == _e635));
let _e860 = select(_e796, 0u, ((_e796 == _e635) || (_e796 == _e716)));
let _e868 = ((select(0u, 1u, (_e635 > 0u)) + select(0u, 1u, (_e856 > 0u))) + select(0u, 1u, (_e860 > 0u)));
if (_e868 == 0u) {
phi_1883_ = 0i;
loop {
let _e871 = phi_1883_;
let _e872 = (_e871 < 16i);
if _e872 {
let _e874 = (_e848 + (_e871 & 15i));
let _e878 = (((f32(_e874) + 0.5f) * 1f) - 0.5f);
let _e882 = (-(((_e289 * _e878) + _e315)) / _e302);
let _e889 = bitcast<f32>((bitcast<u32>(((_e339 * _e878) + ((_e352 * _e882) + _e365))) & 2147483647u));
let _e896 = bitcast<f32>((bitcast<u32>(((_e378 * _e878) + ((_e391 * _e882) + _e404))) & 2147483647u));
let _e900 = (((0.5f * (_e889 + _e896)) / _e407) + _e586);
let _e901 = (1f / 1f);
let _e909 = ((((_e882 + _e900) + 0.5f) * _e901) - 0.5f);
let _e910 = f32(_e853);
let _e911 = (0f - 1f);
let _e913 = select(_e911, _e909, (_e909 > _e911));
let _e915 = select(_e910, _e913, (_e913 < _e910));
let _e922 = select(0i, select(select(i32(_e915), i32(-2147483648), (_e915 < -2147483600f)), 2147483647i, (_e915 > 2147483500f)), (_e915 == _e915));
let _e927 = (((((_e882 - _e900) + 0.5f) * _e901) - 0.5f) + 1f);
let _e928 = (_e910 + 1f);
let _e930 = select(0f, _e927, (_e927 > 0f));
let _e932 = select(_e928, _e930, (_e930 < _e928));
let _e939 = select(0i, select(select(i32(_e932), i32(-2147483648), (_e932 < -2147483600f)), 2147483647i, (_e932 > 2147483500f)), (_e932 == _e932));
let _e950 = ((1e-4f * 1f) * _e407);
let _e952 = select(_e896, _e889, (_e889 > _e896));
let _e954 = select(_e950, _e952, (_e952 > _e950));
let _e956 = select(_e896, _e889, (_e889 < _e896));
let _e958 = select(_e950, _e956, (_e956 > _e950));
let _e960 = (0.5f * (_e954 + _e958));
let _e961 = (0.5f / _e958);
let _e962 = (1f / _e954);
phi_2037_ = 0i;
loop {
let _e964 = phi_2037_;
let _e966 = (((_e939 - select(0i, 1i, (_e932 < f32(_e939)))) + (_e871 >> bitcast<u32>(4u))) + bitcast<i32>(_e964));
let _e967 = (_e966 <= select(-1i, (_e922 - select(0i, 1i, (_e915 < f32(_e922)))), (_e874 <= _e852)));
if _e967 {
let _e973 = (((((f32(_e966) + 0.5f) * 1f) - 0.5f) - _e882) * _e407);
let _e974 = (_e407 * 1f);
let _e976 = (0.5f * _e974);
let _e977 = (_e973 + _e976);
let _e978 = -(_e977);
let _e981 = (_e960 - select(_e978, _e977, (_e977 > _e978)));
let _e983 = select(0f, _e981, (_e981 > 0f));
let _e985 = select(_e958, _e983, (_e983 < _e958));
let _e988 = (_e981 - _e958);
let _e992 = (((_e985 * (_e985 * _e961)) + select(0f, _e988, (_e988 > 0f))) * _e962);
let _e996 = (_e973 - _e976);
let _e997 = -(_e996);
let _e1000 = (_e960 - select(_e997, _e996, (_e996 > _e997)));
let _e1002 = select(0f, _e1000, (_e1000 > 0f));
let _e1004 = select(_e958, _e1002, (_e1002 < _e958));
let _e1007 = (_e1000 - _e958);
let _e1011 = (((_e1004 * (_e1004 * _e961)) + select(0f, _e1007, (_e1007 > 0f))) * _e962);
if _e326 {
phi_2142_ = type_23(_e966, _e874);
} else {
phi_2142_ = type_23(_e874, _e966);
}
let _e1020 = phi_2142_;
let _e1026 = ((_e1020.member_1 * _e803) + _e1020.member);
let _e1028 = (bitcast<i32>(_e138) - 1i);
let _e1030 = select(_e1028, _e1026, (_e1026 < _e1028));
let _e1035 = global_4.member[bitcast<u32>(select(0i, _e1030, (_e1030 > 0i)))];
let _e1036 = (bitcast<i32>((_e799 * _e802)) + _e1026);
let _e1038 = select(_e1028, _e1036, (_e1036 < _e1028));
let _e1043 = global_4.member[bitcast<u32>(select(0i, _e1038, (_e1038 > 0i)))];
let _e1054 = global_1.member.member_2.member;
let _e1055 = (((((f32(_e1020.member) + 0.5f) / f32(_e803)) * 2f) - 1f) * _e1054);
let _e1062 = global_1.member.member_2.member_1;
let _e1063 = ((1f - (((f32(_e1020.member_1) + 0.5f) / f32(_e804)) * 2f)) * _e1062);
let _e1065 = global_1.member.member_3;
let _e1073 = global_1.member.member_4;
let _e1080 = ((_e1065.member * _e1055) + (_e1073.member * _e1063));
let _e1081 = ((_e1065.member_1 * _e1055) + (_e1073.member_1 * _e1063));
let _e1082 = ((_e1065.member_2 * _e1055) + (_e1073.member_2 * _e1063));
let _e1085 = global_1.member.member_2.member_3;
let _e1086 = (_e1085 != 0u);
let _e1088 = global_1.member.member_5;
let _e1095 = select((_e1088.member + _e1080), _e1088.member, _e1086);
let _e1096 = select((_e1088.member_1 + _e1081), _e1088.member_1, _e1086);
let _e1097 = select((_e1088.member_2 + _e1082), _e1088.member_2, _e1086);
let _e1099 = global_1.member.member_6;
let _e1113 = (((_e1095 * _e1095) + (_e1096 * _e1096)) + (_e1097 * _e1097));
let _e1116 = sqrt(select(0f, _e1113, (_e1113 > 0f)));
let _e1117 = (1f / _e1116);
let _e1118 = (_e1095 * _e1117);
let _e1119 = (_e1096 * _e1117);
let _e1120 = (_e1097 * _e1117);
let _e1121 = (_e444 - select(_e1099.member, (_e1099.member + _e1080), _e1086));
let _e1122 = (_e456 - select(_e1099.member_1, (_e1099.member_1 + _e1081), _e1086));
let _e1123 = (_e469 - select(_e1099.member_2, (_e1099.member_2 + _e1082), _e1086));
let _e1128 = (((_e1121 * _e1118) + (_e1122 * _e1119)) + (_e1123 * _e1120));
let _e1133 = (((_e1121 * _e482) + (_e1122 * _e495)) + (_e1123 * _e508));
let _e1138 = (((_e1118 * _e482) + (_e1119 * _e495)) + (_e1120 * _e508));
let _e1141 = ((_e1119 * _e508) - (_e1120 * _e495));
let _e1144 = ((_e1120 * _e482) - (_e1118 * _e508));
let _e1147 = ((_e1118 * _e495) - (_e1119 * _e482));
let _e1152 = (((_e1141 * _e1141) + (_e1144 * _e1144)) + (_e1147 * _e1147));
let _e1155 = (1f / select(1e-9f, _e1152, (_e1152 > 1e-9f)));
let _e1158 = ((_e1128 - (_e1138 * _e1133)) * _e1155);
let _e1161 = (((_e1138 * _e1128) - _e1133) * _e1155);
let _e1167 = (_e1158 - _e1043);
let _e1170 = (_e1161 + select(0f, _e1167, (_e1167 > 0f)));
let _e1173 = global_1.member.member_13.member;
let _e1178 = -((_e1173.member * _e1170));
let _e1180 = select(-87f, _e1178, (_e1178 > -87f));
let _e1182 = select(88f, _e1180, (_e1180 < 88f));
let _e1184 = ((_e1182 * 1.442695f) + 0.5f);
let _e1186 = select(-127f, _e1184, (_e1184 > -127f));
let _e1188 = select(128f, _e1186, (_e1186 < 128f));
let _e1195 = select(0i, select(select(i32(_e1188), i32(-2147483648), (_e1188 < -2147483600f)), 2147483647i, (_e1188 > 2147483500f)), (_e1188 == _e1188));
let _e1199 = (_e1195 - select(0i, 1i, (_e1188 < f32(_e1195))));
let _e1200 = f32(_e1199);
let _e1204 = ((_e1182 - (_e1200 * 0.6933594f)) - (_e1200 * -2.1219444e-4f));
let _e1226 = -((_e1173.member_1 * _e1170));
let _e1228 = select(-87f, _e1226, (_e1226 > -87f));
let _e1230 = select(88f, _e1228, (_e1228 < 88f));
let _e1232 = ((_e1230 * 1.442695f) + 0.5f);
let _e1234 = select(-127f, _e1232, (_e1232 > -127f));
let _e1236 = select(128f, _e1234, (_e1234 < 128f));
let _e1243 = select(0i, select(select(i32(_e1236), i32(-2147483648), (_e1236 < -2147483600f)), 2147483647i, (_e1236 > 2147483500f)), (_e1236 == _e1236));
let _e1247 = (_e1243 - select(0i, 1i, (_e1236 < f32(_e1243))));
let _e1248 = f32(_e1247);
let _e1252 = ((_e1230 - (_e1248 * 0.6933594f)) - (_e1248 * -2.1219444e-4f));
let _e1274 = -((_e1173.member_2 * _e1170));
let _e1276 = select(-87f, _e1274, (_e1274 > -87f));
let _e1278 = select(88f, _e1276, (_e1276 < 88f));
let _e1280 = ((_e1278 * 1.442695f) + 0.5f);
let _e1282 = select(-127f, _e1280, (_e1280 > -127f));
let _e1284 = select(128f, _e1282, (_e1282 < 128f));
let _e1291 = select(0i, select(select(i32(_e1284), i32(-2147483648), (_e1284 < -2147483600f)), 2147483647i, (_e1284 > 2147483500f)), (_e1284 == _e1284));
let _e1295 = (_e1291 - select(0i, 1i, (_e1284 < f32(_e1291))));
let _e1296 = f32(_e1295);
let _e1300 = ((_e1278 - (_e1296 * 0.6933594f)) - (_e1296 * -2.1219444e-4f));
let _e1321 = -(_e1138);
let _e1324 = global_1.member.member_13.member_2;
let _e1325 = (_e1324 * _e1324);
let _e1329 = ((1f + _e1325) - ((2f * _e1324) * _e1321));
let _e1331 = select(1e-9f, _e1329, (_e1329 > 1e-9f));
let _e1343 = global_1.member.member_13.member_3;
let _e1348 = (_e1116 * (select(((1f - _e1325) / (_e1331 * sqrt(select(0f, _e1331, (_e1331 > 0f))))), (0.75f * (1f + (_e1321 * _e1321))), (_e1343 == 1u)) * (0.25f / 3.1415927f)));
let _e1351 = global_1.member.member_13.member_1;
let _e1364 = select(0f, _e1158, (((_e1161 >= 0f) && (_e1161 < _e560)) && (_e1158 > 0f)));
if _e326 {
phi_2662_ = type_23(_e966, _e874);
} else {
phi_2662_ = type_23(_e874, _e966);
}
let _e1375 = phi_2662_;
let _e1378 = (_e967 && (((_e1364 > 0f) && (_e1364 < _e1035)) && true));
let _e1381 = global_1.member.member_18.member;
let _e1382 = (((select(_e992, (1f - _e992), (_e977 >= 0f)) - select(_e1011, (1f - _e1011), (_e996 >= 0f))) * (1f / _e974)) * _e1381);
let _e1386 = select(0f, (((((_e521 * _e1351.member) * ((1f + (_e1204 * (1f + (_e1204 * (0.5f + (_e1204 * (0.16666667f + (_e1204 * (0.041666668f + (_e1204 * (0.008333334f + (_e1204 * (0.001388889f + (_e1204 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1199 + 127i)) << bitcast<u32>(23i))))) * _e1348) * 1f) * _e1382), _e1378);
let _e1387 = select(0f, (((((_e534 * _e1351.member_1) * ((1f + (_e1252 * (1f + (_e1252 * (0.5f + (_e1252 * (0.16666667f + (_e1252 * (0.041666668f + (_e1252 * (0.008333334f + (_e1252 * (0.001388889f + (_e1252 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1247 + 127i)) << bitcast<u32>(23i))))) * _e1348) * 1f) * _e1382), _e1378);
let _e1388 = select(0f, (((((_e547 * _e1351.member_2) * ((1f + (_e1300 * (1f + (_e1300 * (0.5f + (_e1300 * (0.16666667f + (_e1300 * (0.041666668f + (_e1300 * (0.008333334f + (_e1300 * (0.001388889f + (_e1300 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1295 + 127i)) << bitcast<u32>(23i))))) * _e1348) * 1f) * _e1382), _e1378);
let _e1392 = (bitcast<f32>((bitcast<u32>(_e1386) & 2147483647u)) >= 1073741800f);
let _e1393 = (1f / 1048576f);
let _e1396 = ((_e1386 * select(1f, _e1393, _e1392)) + 0.5f);
let _e1398 = select(-1073741800f, _e1396, (_e1396 > -1073741800f));
let _e1400 = select(1073741800f, _e1398, (_e1398 < 1073741800f));
let _e1407 = select(0i, select(select(i32(_e1400), i32(-2147483648), (_e1400 < -2147483600f)), 2147483647i, (_e1400 > 2147483500f)), (_e1400 == _e1400));
let _e1411 = (_e1407 - select(0i, 1i, (_e1400 < f32(_e1407))));
let _e1412 = select(0i, 20i, _e1392);
let _e1416 = (bitcast<u32>(_e1411) << bitcast<u32>((_e1412 & 31i)));
let _e1423 = bitcast<u32>(((_e1411 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1412) & 31i))));
let _e1427 = (bitcast<f32>((bitcast<u32>(_e1387) & 2147483647u)) >= 1073741800f);
let _e1430 = ((_e1387 * select(1f, _e1393, _e1427)) + 0.5f);
let _e1432 = select(-1073741800f, _e1430, (_e1430 > -1073741800f));
let _e1434 = select(1073741800f, _e1432, (_e1432 < 1073741800f));
let _e1441 = select(0i, select(select(i32(_e1434), i32(-2147483648), (_e1434 < -2147483600f)), 2147483647i, (_e1434 > 2147483500f)), (_e1434 == _e1434));
let _e1445 = (_e1441 - select(0i, 1i, (_e1434 < f32(_e1441))));
let _e1446 = select(0i, 20i, _e1427);
let _e1450 = (bitcast<u32>(_e1445) << bitcast<u32>((_e1446 & 31i)));
let _e1457 = bitcast<u32>(((_e1445 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1446) & 31i))));
let _e1461 = (bitcast<f32>((bitcast<u32>(_e1388) & 2147483647u)) >= 1073741800f);
let _e1464 = ((_e1388 * select(1f, _e1393, _e1461)) + 0.5f);
let _e1466 = select(-1073741800f, _e1464, (_e1464 > -1073741800f));
let _e1468 = select(1073741800f, _e1466, (_e1466 < 1073741800f));
let _e1475 = select(0i, select(select(i32(_e1468), i32(-2147483648), (_e1468 < -2147483600f)), 2147483647i, (_e1468 > 2147483500f)), (_e1468 == _e1468));
let _e1479 = (_e1475 - select(0i, 1i, (_e1468 < f32(_e1475))));
let _e1480 = select(0i, 20i, _e1461);
let _e1484 = (bitcast<u32>(_e1479) << bitcast<u32>((_e1480 & 31i)));
let _e1491 = bitcast<u32>(((_e1479 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1480) & 31i))));
let _e1496 = bitcast<i32>(bitcast<u32>((((_e1375.member_1 * _e803) + _e1375.member) * 6i)));
if ((_e1416 | _e1423) == 0u) {
} else {
let _e1499 = bitcast<u32>(_e1496);
if (_e1499 < _e143) {
let _e1503 = atomicAdd((&global_6.member[_e1499]), _e1416);
phi_2895_ = _e1503;
} else {
phi_2895_ = 0u;
}
let _e1505 = phi_2895_;
let _e1509 = (_e1423 + select(0u, 1u, ((_e1505 + _e1416) < _e1416)));
if (_e1509 == 0u) {
} else {
let _e1511 = (_e1499 + 1u);
if (_e1511 < _e143) {
let _e1515 = atomicAdd((&global_6.member[_e1511]), _e1509);
}
}
}
if ((_e1450 | _e1457) == 0u) {
} else {
let _e1519 = bitcast<u32>((_e1496 + 2i));
if (_e1519 < _e143) {
let _e1523 = atomicAdd((&global_6.member[_e1519]), _e1450);
phi_2925_ = _e1523;
} else {
phi_2925_ = 0u;
}
let _e1525 = phi_2925_;
let _e1529 = (_e1457 + select(0u, 1u, ((_e1525 + _e1450) < _e1450)));
if (_e1529 == 0u) {
} else {
let _e1531 = (_e1519 + 1u);
if (_e1531 < _e143) {
let _e1535 = atomicAdd((&global_6.member[_e1531]), _e1529);
}
}
}
if ((_e1484 | _e1491) == 0u) {
} else {
let _e1539 = bitcast<u32>((_e1496 + 4i));
if (_e1539 < _e143) {
let _e1543 = atomicAdd((&global_6.member[_e1539]), _e1484);
phi_2955_ = _e1543;
} else {
phi_2955_ = 0u;
}
let _e1545 = phi_2955_;
let _e1549 = (_e1491 + select(0u, 1u, ((_e1545 + _e1484) < _e1484)));
if (_e1549 == 0u) {
} else {
let _e1551 = (_e1539 + 1u);
if (_e1551 < _e143) {
let _e1555 = atomicAdd((&global_6.member[_e1551]), _e1549);
}
}
}
phi_2038_ = (_e964 + 1i);
} else {
phi_2038_ = i32();
}
let _e1558 = phi_2038_;
continue;
continuing {
phi_2037_ = _e1558;
break if !(_e967);
}
}
phi_1884_ = (_e871 + 1i);
} else {
phi_1884_ = i32();
}
let _e1562 = phi_1884_;
continue;
continuing {
phi_1883_ = _e1562;
break if !(_e872);
}
}
} else {
if (_e868 == 1u) {
phi_3004_ = 0i;
loop {
let _e1566 = phi_3004_;
let _e1567 = (_e1566 < 16i);
if _e1567 {
let _e1569 = (_e848 + (_e1566 & 15i));
let _e1571 = (f32(_e1569) + 0.5f);
let _e1573 = ((_e1571 * 1f) - 0.5f);
let _e1577 = (-(((_e289 * _e1573) + _e315)) / _e302);
let _e1584 = bitcast<f32>((bitcast<u32>(((_e339 * _e1573) + ((_e352 * _e1577) + _e365))) & 2147483647u));
let _e1591 = bitcast<f32>((bitcast<u32>(((_e378 * _e1573) + ((_e391 * _e1577) + _e404))) & 2147483647u));
let _e1595 = (((0.5f * (_e1584 + _e1591)) / _e407) + _e586);
let _e1596 = (1f / 1f);
let _e1604 = ((((_e1577 + _e1595) + 0.5f) * _e1596) - 0.5f);
let _e1605 = f32(_e853);
let _e1606 = (0f - 1f);
let _e1608 = select(_e1606, _e1604, (_e1604 > _e1606));
let _e1610 = select(_e1605, _e1608, (_e1608 < _e1605));
let _e1617 = select(0i, select(select(i32(_e1610), i32(-2147483648), (_e1610 < -2147483600f)), 2147483647i, (_e1610 > 2147483500f)), (_e1610 == _e1610));
let _e1622 = (((((_e1577 - _e1595) + 0.5f) * _e1596) - 0.5f) + 1f);
let _e1623 = (_e1605 + 1f);
let _e1625 = select(0f, _e1622, (_e1622 > 0f));
let _e1627 = select(_e1623, _e1625, (_e1625 < _e1623));
let _e1634 = select(0i, select(select(i32(_e1627), i32(-2147483648), (_e1627 < -2147483600f)), 2147483647i, (_e1627 > 2147483500f)), (_e1627 == _e1627));
let _e1645 = ((1e-4f * 1f) * _e407);
let _e1647 = select(_e1591, _e1584, (_e1584 > _e1591));
let _e1649 = select(_e1645, _e1647, (_e1647 > _e1645));
let _e1651 = select(_e1591, _e1584, (_e1584 < _e1591));
let _e1653 = select(_e1645, _e1651, (_e1651 > _e1645));
let _e1655 = (0.5f * (_e1649 + _e1653));
let _e1656 = (0.5f / _e1653);
let _e1657 = (1f / _e1649);
phi_3158_ = 0i;
loop {
let _e1659 = phi_3158_;
let _e1661 = (((_e1634 - select(0i, 1i, (_e1627 < f32(_e1634)))) + (_e1566 >> bitcast<u32>(4u))) + bitcast<i32>(_e1659));
let _e1662 = (_e1661 <= select(-1i, (_e1617 - select(0i, 1i, (_e1610 < f32(_e1617)))), (_e1569 <= _e852)));
if _e1662 {
let _e1664 = (f32(_e1661) + 0.5f);
let _e1668 = ((((_e1664 * 1f) - 0.5f) - _e1577) * _e407);
let _e1669 = (_e407 * 1f);
let _e1671 = (0.5f * _e1669);
let _e1672 = (_e1668 + _e1671);
let _e1673 = -(_e1672);
let _e1676 = (_e1655 - select(_e1673, _e1672, (_e1672 > _e1673)));
let _e1678 = select(0f, _e1676, (_e1676 > 0f));
let _e1680 = select(_e1653, _e1678, (_e1678 < _e1653));
let _e1683 = (_e1676 - _e1653);
let _e1687 = (((_e1680 * (_e1680 * _e1656)) + select(0f, _e1683, (_e1683 > 0f))) * _e1657);
let _e1691 = (_e1668 - _e1671);
let _e1692 = -(_e1691);
let _e1695 = (_e1655 - select(_e1692, _e1691, (_e1691 > _e1692)));
let _e1697 = select(0f, _e1695, (_e1695 > 0f));
let _e1699 = select(_e1653, _e1697, (_e1697 < _e1653));
let _e1702 = (_e1695 - _e1653);
let _e1706 = (((_e1699 * (_e1699 * _e1656)) + select(0f, _e1702, (_e1702 > 0f))) * _e1657);
if _e326 {
phi_3263_ = type_23(_e1661, _e1569);
} else {
phi_3263_ = type_23(_e1569, _e1661);
}
let _e1715 = phi_3263_;
let _e1721 = ((_e1715.member_1 * _e803) + _e1715.member);
let _e1723 = (bitcast<i32>(_e138) - 1i);
let _e1725 = select(_e1723, _e1721, (_e1721 < _e1723));
let _e1730 = global_4.member[bitcast<u32>(select(0i, _e1725, (_e1725 > 0i)))];
let _e1731 = (bitcast<i32>((_e799 * _e802)) + _e1721);
let _e1733 = select(_e1723, _e1731, (_e1731 < _e1723));
let _e1738 = global_4.member[bitcast<u32>(select(0i, _e1733, (_e1733 > 0i)))];
let _e1741 = f32(_e803);
let _e1742 = f32(_e804);
let _e1749 = global_1.member.member_2.member;
let _e1750 = (((((f32(_e1715.member) + 0.5f) / _e1741) * 2f) - 1f) * _e1749);
let _e1757 = global_1.member.member_2.member_1;
let _e1758 = ((1f - (((f32(_e1715.member_1) + 0.5f) / _e1742) * 2f)) * _e1757);
let _e1760 = global_1.member.member_3;
let _e1768 = global_1.member.member_4;
let _e1775 = ((_e1760.member * _e1750) + (_e1768.member * _e1758));
let _e1776 = ((_e1760.member_1 * _e1750) + (_e1768.member_1 * _e1758));
let _e1777 = ((_e1760.member_2 * _e1750) + (_e1768.member_2 * _e1758));
let _e1780 = global_1.member.member_2.member_3;
let _e1781 = (_e1780 != 0u);
let _e1783 = global_1.member.member_5;
let _e1790 = select((_e1783.member + _e1775), _e1783.member, _e1781);
let _e1791 = select((_e1783.member_1 + _e1776), _e1783.member_1, _e1781);
let _e1792 = select((_e1783.member_2 + _e1777), _e1783.member_2, _e1781);
let _e1794 = global_1.member.member_6;
let _e1808 = (((_e1790 * _e1790) + (_e1791 * _e1791)) + (_e1792 * _e1792));
let _e1811 = sqrt(select(0f, _e1808, (_e1808 > 0f)));
let _e1812 = (1f / _e1811);
let _e1813 = (_e1790 * _e1812);
let _e1814 = (_e1791 * _e1812);
let _e1815 = (_e1792 * _e1812);
let _e1816 = (_e444 - select(_e1794.member, (_e1794.member + _e1775), _e1781));
let _e1817 = (_e456 - select(_e1794.member_1, (_e1794.member_1 + _e1776), _e1781));
let _e1818 = (_e469 - select(_e1794.member_2, (_e1794.member_2 + _e1777), _e1781));
let _e1823 = (((_e1816 * _e1813) + (_e1817 * _e1814)) + (_e1818 * _e1815));
let _e1828 = (((_e1816 * _e482) + (_e1817 * _e495)) + (_e1818 * _e508));
let _e1833 = (((_e1813 * _e482) + (_e1814 * _e495)) + (_e1815 * _e508));
let _e1836 = ((_e1814 * _e508) - (_e1815 * _e495));
let _e1839 = ((_e1815 * _e482) - (_e1813 * _e508));
let _e1842 = ((_e1813 * _e495) - (_e1814 * _e482));
let _e1847 = (((_e1836 * _e1836) + (_e1839 * _e1839)) + (_e1842 * _e1842));
let _e1850 = (1f / select(1e-9f, _e1847, (_e1847 > 1e-9f)));
let _e1853 = ((_e1823 - (_e1833 * _e1828)) * _e1850);
let _e1856 = (((_e1833 * _e1823) - _e1828) * _e1850);
let _e1862 = (_e1853 - _e1738);
let _e1865 = (_e1856 + select(0f, _e1862, (_e1862 > 0f)));
let _e1868 = global_1.member.member_13.member;
let _e1873 = -((_e1868.member * _e1865));
let _e1875 = select(-87f, _e1873, (_e1873 > -87f));
let _e1877 = select(88f, _e1875, (_e1875 < 88f));
let _e1879 = ((_e1877 * 1.442695f) + 0.5f);
let _e1881 = select(-127f, _e1879, (_e1879 > -127f));
let _e1883 = select(128f, _e1881, (_e1881 < 128f));
let _e1890 = select(0i, select(select(i32(_e1883), i32(-2147483648), (_e1883 < -2147483600f)), 2147483647i, (_e1883 > 2147483500f)), (_e1883 == _e1883));
let _e1894 = (_e1890 - select(0i, 1i, (_e1883 < f32(_e1890))));
let _e1895 = f32(_e1894);
let _e1899 = ((_e1877 - (_e1895 * 0.6933594f)) - (_e1895 * -2.1219444e-4f));
let _e1921 = -((_e1868.member_1 * _e1865));
let _e1923 = select(-87f, _e1921, (_e1921 > -87f));
let _e1925 = select(88f, _e1923, (_e1923 < 88f));
let _e1927 = ((_e1925 * 1.442695f) + 0.5f);
let _e1929 = select(-127f, _e1927, (_e1927 > -127f));
let _e1931 = select(128f, _e1929, (_e1929 < 128f));
let _e1938 = select(0i, select(select(i32(_e1931), i32(-2147483648), (_e1931 < -2147483600f)), 2147483647i, (_e1931 > 2147483500f)), (_e1931 == _e1931));
let _e1942 = (_e1938 - select(0i, 1i, (_e1931 < f32(_e1938))));
let _e1943 = f32(_e1942);
let _e1947 = ((_e1925 - (_e1943 * 0.6933594f)) - (_e1943 * -2.1219444e-4f));
let _e1969 = -((_e1868.member_2 * _e1865));
let _e1971 = select(-87f, _e1969, (_e1969 > -87f));
let _e1973 = select(88f, _e1971, (_e1971 < 88f));
let _e1975 = ((_e1973 * 1.442695f) + 0.5f);
let _e1977 = select(-127f, _e1975, (_e1975 > -127f));
let _e1979 = select(128f, _e1977, (_e1977 < 128f));
let _e1986 = select(0i, select(select(i32(_e1979), i32(-2147483648), (_e1979 < -2147483600f)), 2147483647i, (_e1979 > 2147483500f)), (_e1979 == _e1979));
let _e1990 = (_e1986 - select(0i, 1i, (_e1979 < f32(_e1986))));
let _e1991 = f32(_e1990);
let _e1995 = ((_e1973 - (_e1991 * 0.6933594f)) - (_e1991 * -2.1219444e-4f));
let _e2016 = -(_e1833);
let _e2019 = global_1.member.member_13.member_2;
let _e2020 = (_e2019 * _e2019);
let _e2024 = ((1f + _e2020) - ((2f * _e2019) * _e2016));
let _e2026 = select(1e-9f, _e2024, (_e2024 > 1e-9f));
let _e2038 = global_1.member.member_13.member_3;
let _e2043 = (_e1811 * (select(((1f - _e2020) / (_e2026 * sqrt(select(0f, _e2026, (_e2026 > 0f))))), (0.75f * (1f + (_e2016 * _e2016))), (_e2038 == 1u)) * (0.25f / 3.1415927f)));
let _e2046 = global_1.member.member_13.member_1;
let _e2059 = select(0f, _e1853, (((_e1856 >= 0f) && (_e1856 < _e560)) && (_e1853 > 0f)));
let _e2061 = ((_e635 + _e856) + _e860);
let _e2062 = (_e2061 & 31u);
let _e2064 = (1u << bitcast<u32>(_e2062));
let _e2073 = bitcast<i32>((((_e799 + _e2064) - 1u) >> bitcast<u32>(_e2062)));
let _e2074 = bitcast<i32>((((_e802 + _e2064) - 1u) >> bitcast<u32>(_e2062)));
if _e326 {
phi_3809_ = type_23(_e2074, _e2073);
} else {
phi_3809_ = type_23(_e2073, _e2074);
}
let _e2078 = phi_3809_;
let _e2083 = f32((1i << bitcast<u32>(_e2062)));
let _e2084 = (1f / _e2083);
let _e2086 = ((_e1571 * _e2084) - 0.5f);
let _e2088 = ((_e1664 * _e2084) - 0.5f);
let _e2090 = select(-1f, _e2086, (_e2086 > -1f));
let _e2092 = select(1e6f, _e2090, (_e2090 < 1e6f));
let _e2099 = select(0i, select(select(i32(_e2092), i32(-2147483648), (_e2092 < -2147483600f)), 2147483647i, (_e2092 > 2147483500f)), (_e2092 == _e2092));
let _e2103 = (_e2099 - select(0i, 1i, (_e2092 < f32(_e2099))));
let _e2105 = select(-1f, _e2088, (_e2088 > -1f));
let _e2107 = select(1e6f, _e2105, (_e2105 < 1e6f));
let _e2114 = select(0i, select(select(i32(_e2107), i32(-2147483648), (_e2107 < -2147483600f)), 2147483647i, (_e2107 > 2147483500f)), (_e2107 == _e2107));
let _e2118 = (_e2114 - select(0i, 1i, (_e2107 < f32(_e2114))));
let _e2120 = (_e2086 - f32(_e2103));
let _e2122 = (_e2088 - f32(_e2118));
let _e2123 = (1f - _e2120);
let _e2124 = (1f - _e2122);
let _e2127 = select(_e2103, 0i, (_e2103 < 0i));
let _e2128 = (_e2127 >= _e2078.member);
if _e2128 {
phi_3887_ = (_e2078.member - 1i);
} else {
phi_3887_ = _e2127;
}
let _e2131 = phi_3887_;
let _e2133 = select(_e2118, 0i, (_e2118 < 0i));
let _e2134 = (_e2133 >= _e2078.member_1);
if _e2134 {
phi_3898_ = (_e2078.member_1 - 1i);
} else {
phi_3898_ = _e2133;
}
let _e2137 = phi_3898_;
let _e2141 = (((f32(_e2131) + 0.5f) * _e2083) - 0.5f);
let _e2145 = (((f32(_e2137) + 0.5f) * _e2083) - 0.5f);
if _e326 {
phi_3926_ = type_23(_e2137, _e2131);
} else {
phi_3926_ = type_23(_e2131, _e2137);
}
let _e2151 = phi_3926_;
let _e2157 = bitcast<i32>(((_e799 + 1u) >> bitcast<u32>(1u)));
let _e2160 = global_1.member.member_18.member_6;
let _e2163 = global_1.member.member_18.member_7;
let _e2166 = global_1.member.member_18.member_8;
let _e2167 = (_e2061 == 0u);
if _e2167 {
phi_3977_ = 0u;
} else {
if (_e2061 == 1u) {
phi_3976_ = 0u;
} else {
if (_e2061 == 2u) {
phi_3975_ = _e2160;
} else {
phi_3975_ = select(_e2166, _e2163, (_e2061 == 3u));
}
let _e2173 = phi_3975_;
phi_3976_ = _e2173;
}
let _e2175 = phi_3976_;
phi_3977_ = _e2175;
}
let _e2177 = phi_3977_;
local_64 = (((bitcast<i32>(_e2177) + _e2151.member_1) * _e2157) + _e2151.member);
let _e2182 = local_64;
let _e2184 = (bitcast<i32>(_e141) - 1i);
let _e2186 = select(_e2184, _e2182, (_e2182 < _e2184));
let _e2191 = global_5.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2196 = (((((select(_e2141, _e2145, _e326) + 0.5f) / _e1741) * 2f) - 1f) * _e1749);
let _e2201 = ((1f - (((select(_e2145, _e2141, _e326) + 0.5f) / _e1742) * 2f)) * _e1757);
let _e2208 = ((_e1760.member * _e2196) + (_e1768.member * _e2201));
let _e2209 = ((_e1760.member_1 * _e2196) + (_e1768.member_1 * _e2201));
let _e2210 = ((_e1760.member_2 * _e2196) + (_e1768.member_2 * _e2201));
let _e2214 = select((_e1783.member + _e2208), _e1783.member, _e1781);
let _e2215 = select((_e1783.member_1 + _e2209), _e1783.member_1, _e1781);
let _e2216 = select((_e1783.member_2 + _e2210), _e1783.member_2, _e1781);
let _e2227 = (((_e2214 * _e2214) + (_e2215 * _e2215)) + (_e2216 * _e2216));
let _e2231 = (1f / sqrt(select(0f, _e2227, (_e2227 > 0f))));
let _e2232 = (_e2214 * _e2231);
let _e2233 = (_e2215 * _e2231);
let _e2234 = (_e2216 * _e2231);
let _e2235 = (_e444 - select(_e1794.member, (_e1794.member + _e2208), _e1781));
let _e2236 = (_e456 - select(_e1794.member_1, (_e1794.member_1 + _e2209), _e1781));
let _e2237 = (_e469 - select(_e1794.member_2, (_e1794.member_2 + _e2210), _e1781));
let _e2242 = (((_e2235 * _e2232) + (_e2236 * _e2233)) + (_e2237 * _e2234));
let _e2247 = (((_e2235 * _e482) + (_e2236 * _e495)) + (_e2237 * _e508));
let _e2252 = (((_e2232 * _e482) + (_e2233 * _e495)) + (_e2234 * _e508));
let _e2255 = ((_e2233 * _e508) - (_e2234 * _e495));
let _e2258 = ((_e2234 * _e482) - (_e2232 * _e508));
let _e2261 = ((_e2232 * _e495) - (_e2233 * _e482));
let _e2266 = (((_e2255 * _e2255) + (_e2258 * _e2258)) + (_e2261 * _e2261));
let _e2269 = (1f / select(1e-9f, _e2266, (_e2266 > 1e-9f)));
let _e2272 = ((_e2242 - (_e2252 * _e2247)) * _e2269);
let _e2275 = (((_e2252 * _e2242) - _e2247) * _e2269);
let _e2281 = select(0f, _e2272, (((_e2275 >= 0f) && (_e2275 < _e560)) && (_e2272 > 0f)));
let _e2283 = (_e2131 << bitcast<u32>(_e2062));
let _e2295 = (_e2103 + 1i);
let _e2298 = select(_e2295, 0i, (_e2295 < 0i));
let _e2299 = (_e2298 >= _e2078.member);
if _e2299 {
phi_4394_ = (_e2078.member - 1i);
} else {
phi_4394_ = _e2298;
}
let _e2302 = phi_4394_;
if _e2134 {
phi_4405_ = (_e2078.member_1 - 1i);
} else {
phi_4405_ = _e2133;
}
let _e2305 = phi_4405_;
let _e2309 = (((f32(_e2302) + 0.5f) * _e2083) - 0.5f);
let _e2313 = (((f32(_e2305) + 0.5f) * _e2083) - 0.5f);
if _e326 {
phi_4433_ = type_23(_e2305, _e2302);
} else {
phi_4433_ = type_23(_e2302, _e2305);
}
let _e2319 = phi_4433_;
if _e2167 {
phi_4484_ = 0u;
} else {
if (_e2061 == 1u) {
phi_4483_ = 0u;
} else {
if (_e2061 == 2u) {
phi_4482_ = _e2160;
} else {
phi_4482_ = select(_e2166, _e2163, (_e2061 == 3u));
}
let _e2327 = phi_4482_;
phi_4483_ = _e2327;
}
let _e2329 = phi_4483_;
phi_4484_ = _e2329;
}
let _e2331 = phi_4484_;
local_62 = (((bitcast<i32>(_e2331) + _e2319.member_1) * _e2157) + _e2319.member);
let _e2336 = local_62;
let _e2338 = select(_e2184, _e2336, (_e2336 < _e2184));
let _e2343 = global_5.member[bitcast<u32>(select(0i, _e2338, (_e2338 > 0i)))];
let _e2348 = (((((select(_e2309, _e2313, _e326) + 0.5f) / _e1741) * 2f) - 1f) * _e1749);
let _e2353 = ((1f - (((select(_e2313, _e2309, _e326) + 0.5f) / _e1742) * 2f)) * _e1757);
let _e2360 = ((_e1760.member * _e2348) + (_e1768.member * _e2353));
let _e2361 = ((_e1760.member_1 * _e2348) + (_e1768.member_1 * _e2353));
let _e2362 = ((_e1760.member_2 * _e2348) + (_e1768.member_2 * _e2353));
let _e2366 = select((_e1783.member + _e2360), _e1783.member, _e1781);
let _e2367 = select((_e1783.member_1 + _e2361), _e1783.member_1, _e1781);
let _e2368 = select((_e1783.member_2 + _e2362), _e1783.member_2, _e1781);
let _e2379 = (((_e2366 * _e2366) + (_e2367 * _e2367)) + (_e2368 * _e2368));
let _e2383 = (1f / sqrt(select(0f, _e2379, (_e2379 > 0f))));
let _e2384 = (_e2366 * _e2383);
let _e2385 = (_e2367 * _e2383);
let _e2386 = (_e2368 * _e2383);
let _e2387 = (_e444 - select(_e1794.member, (_e1794.member + _e2360), _e1781));
let _e2388 = (_e456 - select(_e1794.member_1, (_e1794.member_1 + _e2361), _e1781));
let _e2389 = (_e469 - select(_e1794.member_2, (_e1794.member_2 + _e2362), _e1781));
let _e2394 = (((_e2387 * _e2384) + (_e2388 * _e2385)) + (_e2389 * _e2386));
let _e2399 = (((_e2387 * _e482) + (_e2388 * _e495)) + (_e2389 * _e508));
let _e2404 = (((_e2384 * _e482) + (_e2385 * _e495)) + (_e2386 * _e508));
let _e2407 = ((_e2385 * _e508) - (_e2386 * _e495));
let _e2410 = ((_e2386 * _e482) - (_e2384 * _e508));
let _e2413 = ((_e2384 * _e495) - (_e2385 * _e482));
let _e2418 = (((_e2407 * _e2407) + (_e2410 * _e2410)) + (_e2413 * _e2413));
let _e2421 = (1f / select(1e-9f, _e2418, (_e2418 > 1e-9f)));
let _e2424 = ((_e2394 - (_e2404 * _e2399)) * _e2421);
let _e2427 = (((_e2404 * _e2394) - _e2399) * _e2421);
let _e2433 = select(0f, _e2424, (((_e2427 >= 0f) && (_e2427 < _e560)) && (_e2424 > 0f)));
let _e2435 = (_e2302 << bitcast<u32>(_e2062));
let _e2447 = (_e2118 + 1i);
if _e2128 {
phi_4901_ = (_e2078.member - 1i);
} else {
phi_4901_ = _e2127;
}
let _e2451 = phi_4901_;
let _e2453 = select(_e2447, 0i, (_e2447 < 0i));
let _e2454 = (_e2453 >= _e2078.member_1);
if _e2454 {
phi_4912_ = (_e2078.member_1 - 1i);
} else {
phi_4912_ = _e2453;
}
let _e2457 = phi_4912_;
let _e2461 = (((f32(_e2451) + 0.5f) * _e2083) - 0.5f);
let _e2465 = (((f32(_e2457) + 0.5f) * _e2083) - 0.5f);
if _e326 {
phi_4940_ = type_23(_e2457, _e2451);
} else {
phi_4940_ = type_23(_e2451, _e2457);
}
let _e2471 = phi_4940_;
if _e2167 {
phi_4991_ = 0u;
} else {
if (_e2061 == 1u) {
phi_4990_ = 0u;
} else {
if (_e2061 == 2u) {
phi_4989_ = _e2160;
} else {
phi_4989_ = select(_e2166, _e2163, (_e2061 == 3u));
}
let _e2479 = phi_4989_;
phi_4990_ = _e2479;
}
let _e2481 = phi_4990_;
phi_4991_ = _e2481;
}
let _e2483 = phi_4991_;
local_60 = (((bitcast<i32>(_e2483) + _e2471.member_1) * _e2157) + _e2471.member);
let _e2488 = local_60;
let _e2490 = select(_e2184, _e2488, (_e2488 < _e2184));
let _e2495 = global_5.member[bitcast<u32>(select(0i, _e2490, (_e2490 > 0i)))];
let _e2500 = (((((select(_e2461, _e2465, _e326) + 0.5f) / _e1741) * 2f) - 1f) * _e1749);
let _e2505 = ((1f - (((select(_e2465, _e2461, _e326) + 0.5f) / _e1742) * 2f)) * _e1757);
let _e2512 = ((_e1760.member * _e2500) + (_e1768.member * _e2505));
let _e2513 = ((_e1760.member_1 * _e2500) + (_e1768.member_1 * _e2505));
let _e2514 = ((_e1760.member_2 * _e2500) + (_e1768.member_2 * _e2505));
let _e2518 = select((_e1783.member + _e2512), _e1783.member, _e1781);
let _e2519 = select((_e1783.member_1 + _e2513), _e1783.member_1, _e1781);
let _e2520 = select((_e1783.member_2 + _e2514), _e1783.member_2, _e1781);
let _e2531 = (((_e2518 * _e2518) + (_e2519 * _e2519)) + (_e2520 * _e2520));
let _e2535 = (1f / sqrt(select(0f, _e2531, (_e2531 > 0f))));
let _e2536 = (_e2518 * _e2535);
let _e2537 = (_e2519 * _e2535);
let _e2538 = (_e2520 * _e2535);
let _e2539 = (_e444 - select(_e1794.member, (_e1794.member + _e2512), _e1781));
let _e2540 = (_e456 - select(_e1794.member_1, (_e1794.member_1 + _e2513), _e1781));
let _e2541 = (_e469 - select(_e1794.member_2, (_e1794.member_2 + _e2514), _e1781));
let _e2546 = (((_e2539 * _e2536) + (_e2540 * _e2537)) + (_e2541 * _e2538));
let _e2551 = (((_e2539 * _e482) + (_e2540 * _e495)) + (_e2541 * _e508));
let _e2556 = (((_e2536 * _e482) + (_e2537 * _e495)) + (_e2538 * _e508));
let _e2559 = ((_e2537 * _e508) - (_e2538 * _e495));
let _e2562 = ((_e2538 * _e482) - (_e2536 * _e508));
let _e2565 = ((_e2536 * _e495) - (_e2537 * _e482));
let _e2570 = (((_e2559 * _e2559) + (_e2562 * _e2562)) + (_e2565 * _e2565));
let _e2573 = (1f / select(1e-9f, _e2570, (_e2570 > 1e-9f)));
let _e2576 = ((_e2546 - (_e2556 * _e2551)) * _e2573);
let _e2579 = (((_e2556 * _e2546) - _e2551) * _e2573);
let _e2585 = select(0f, _e2576, (((_e2579 >= 0f) && (_e2579 < _e560)) && (_e2576 > 0f)));
let _e2587 = (_e2451 << bitcast<u32>(_e2062));
if _e2299 {
phi_5408_ = (_e2078.member - 1i);
} else {
phi_5408_ = _e2298;
}
let _e2602 = phi_5408_;
if _e2454 {
phi_5419_ = (_e2078.member_1 - 1i);
} else {
phi_5419_ = _e2453;
}
let _e2605 = phi_5419_;
let _e2609 = (((f32(_e2602) + 0.5f) * _e2083) - 0.5f);
let _e2613 = (((f32(_e2605) + 0.5f) * _e2083) - 0.5f);
if _e326 {
phi_5447_ = type_23(_e2605, _e2602);
} else {
phi_5447_ = type_23(_e2602, _e2605);
}
let _e2619 = phi_5447_;
if _e2167 {
phi_5498_ = 0u;
} else {
if (_e2061 == 1u) {
phi_5497_ = 0u;
} else {
if (_e2061 == 2u) {
phi_5496_ = _e2160;
} else {
phi_5496_ = select(_e2166, _e2163, (_e2061 == 3u));
}
let _e2627 = phi_5496_;
phi_5497_ = _e2627;
}
let _e2629 = phi_5497_;
phi_5498_ = _e2629;
}
let _e2631 = phi_5498_;
local_58 = (((bitcast<i32>(_e2631) + _e2619.member_1) * _e2157) + _e2619.member);
let _e2636 = local_58;
let _e2638 = select(_e2184, _e2636, (_e2636 < _e2184));
let _e2643 = global_5.member[bitcast<u32>(select(0i, _e2638, (_e2638 > 0i)))];
let _e2648 = (((((select(_e2609, _e2613, _e326) + 0.5f) / _e1741) * 2f) - 1f) * _e1749);
let _e2653 = ((1f - (((select(_e2613, _e2609, _e326) + 0.5f) / _e1742) * 2f)) * _e1757);
let _e2660 = ((_e1760.member * _e2648) + (_e1768.member * _e2653));
let _e2661 = ((_e1760.member_1 * _e2648) + (_e1768.member_1 * _e2653));
let _e2662 = ((_e1760.member_2 * _e2648) + (_e1768.member_2 * _e2653));
let _e2666 = select((_e1783.member + _e2660), _e1783.member, _e1781);
let _e2667 = select((_e1783.member_1 + _e2661), _e1783.member_1, _e1781);
let _e2668 = select((_e1783.member_2 + _e2662), _e1783.member_2, _e1781);
let _e2679 = (((_e2666 * _e2666) + (_e2667 * _e2667)) + (_e2668 * _e2668));
let _e2683 = (1f / sqrt(select(0f, _e2679, (_e2679 > 0f))));
let _e2684 = (_e2666 * _e2683);
let _e2685 = (_e2667 * _e2683);
let _e2686 = (_e2668 * _e2683);
let _e2687 = (_e444 - select(_e1794.member, (_e1794.member + _e2660), _e1781));
let _e2688 = (_e456 - select(_e1794.member_1, (_e1794.member_1 + _e2661), _e1781));
let _e2689 = (_e469 - select(_e1794.member_2, (_e1794.member_2 + _e2662), _e1781));
let _e2694 = (((_e2687 * _e2684) + (_e2688 * _e2685)) + (_e2689 * _e2686));
let _e2699 = (((_e2687 * _e482) + (_e2688 * _e495)) + (_e2689 * _e508));
let _e2704 = (((_e2684 * _e482) + (_e2685 * _e495)) + (_e2686 * _e508));
let _e2707 = ((_e2685 * _e508) - (_e2686 * _e495));
let _e2710 = ((_e2686 * _e482) - (_e2684 * _e508));
let _e2713 = ((_e2684 * _e495) - (_e2685 * _e482));
let _e2718 = (((_e2707 * _e2707) + (_e2710 * _e2710)) + (_e2713 * _e2713));
let _e2721 = (1f / select(1e-9f, _e2718, (_e2718 > 1e-9f)));
let _e2724 = ((_e2694 - (_e2704 * _e2699)) * _e2721);
let _e2727 = (((_e2704 * _e2694) - _e2699) * _e2721);
let _e2733 = select(0f, _e2724, (((_e2727 >= 0f) && (_e2727 < _e560)) && (_e2724 > 0f)));
let _e2735 = (_e2602 << bitcast<u32>(_e2062));
let _e2747 = select(((((1f - select(0f, (_e2123 * _e2124), (((select(select(_e635, _e796, (_e2283 >= _e561)), _e716, (_e2283 < _e171)) == _e2061) && (_e2281 > 0f)) && (_e2281 < _e2191)))) - select(0f, (_e2120 * _e2124), (((select(select(_e635, _e796, (_e2435 >= _e561)), _e716, (_e2435 < _e171)) == _e2061) && (_e2433 > 0f)) && (_e2433 < _e2343)))) - select(0f, (_e2123 * _e2122), (((select(select(_e635, _e796, (_e2587 >= _e561)), _e716, (_e2587 < _e171)) == _e2061) && (_e2585 > 0f)) && (_e2585 < _e2495)))) - select(0f, (_e2120 * _e2122), (((select(select(_e635, _e796, (_e2735 >= _e561)), _e716, (_e2735 < _e171)) == _e2061) && (_e2733 > 0f)) && (_e2733 < _e2643)))), 1f, _e2167);
if _e326 {
phi_5924_ = type_23(_e1661, _e1569);
} else {
phi_5924_ = type_23(_e1569, _e1661);
}
let _e2762 = phi_5924_;
let _e2765 = (_e1662 && (((_e2059 > 0f) && (_e2059 < _e1730)) && (bitcast<f32>((bitcast<u32>(_e2747) & 2147483647u)) > 1e-6f)));
let _e2768 = global_1.member.member_18.member;
let _e2769 = (((select(_e1687, (1f - _e1687), (_e1672 >= 0f)) - select(_e1706, (1f - _e1706), (_e1691 >= 0f))) * (1f / _e1669)) * _e2768);
let _e2773 = select(0f, (((((_e521 * _e2046.member) * ((1f + (_e1899 * (1f + (_e1899 * (0.5f + (_e1899 * (0.16666667f + (_e1899 * (0.041666668f + (_e1899 * (0.008333334f + (_e1899 * (0.001388889f + (_e1899 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1894 + 127i)) << bitcast<u32>(23i))))) * _e2043) * _e2747) * _e2769), _e2765);
let _e2774 = select(0f, (((((_e534 * _e2046.member_1) * ((1f + (_e1947 * (1f + (_e1947 * (0.5f + (_e1947 * (0.16666667f + (_e1947 * (0.041666668f + (_e1947 * (0.008333334f + (_e1947 * (0.001388889f + (_e1947 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1942 + 127i)) << bitcast<u32>(23i))))) * _e2043) * _e2747) * _e2769), _e2765);
let _e2775 = select(0f, (((((_e547 * _e2046.member_2) * ((1f + (_e1995 * (1f + (_e1995 * (0.5f + (_e1995 * (0.16666667f + (_e1995 * (0.041666668f + (_e1995 * (0.008333334f + (_e1995 * (0.001388889f + (_e1995 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1990 + 127i)) << bitcast<u32>(23i))))) * _e2043) * _e2747) * _e2769), _e2765);
let _e2779 = (bitcast<f32>((bitcast<u32>(_e2773) & 2147483647u)) >= 1073741800f);
let _e2780 = (1f / 1048576f);
let _e2783 = ((_e2773 * select(1f, _e2780, _e2779)) + 0.5f);
let _e2785 = select(-1073741800f, _e2783, (_e2783 > -1073741800f));
let _e2787 = select(1073741800f, _e2785, (_e2785 < 1073741800f));
let _e2794 = select(0i, select(select(i32(_e2787), i32(-2147483648), (_e2787 < -2147483600f)), 2147483647i, (_e2787 > 2147483500f)), (_e2787 == _e2787));
let _e2798 = (_e2794 - select(0i, 1i, (_e2787 < f32(_e2794))));
let _e2799 = select(0i, 20i, _e2779);
let _e2803 = (bitcast<u32>(_e2798) << bitcast<u32>((_e2799 & 31i)));
let _e2810 = bitcast<u32>(((_e2798 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2799) & 31i))));
let _e2814 = (bitcast<f32>((bitcast<u32>(_e2774) & 2147483647u)) >= 1073741800f);
let _e2817 = ((_e2774 * select(1f, _e2780, _e2814)) + 0.5f);
let _e2819 = select(-1073741800f, _e2817, (_e2817 > -1073741800f));
let _e2821 = select(1073741800f, _e2819, (_e2819 < 1073741800f));
let _e2828 = select(0i, select(select(i32(_e2821), i32(-2147483648), (_e2821 < -2147483600f)), 2147483647i, (_e2821 > 2147483500f)), (_e2821 == _e2821));
let _e2832 = (_e2828 - select(0i, 1i, (_e2821 < f32(_e2828))));
let _e2833 = select(0i, 20i, _e2814);
let _e2837 = (bitcast<u32>(_e2832) << bitcast<u32>((_e2833 & 31i)));
let _e2844 = bitcast<u32>(((_e2832 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2833) & 31i))));
let _e2848 = (bitcast<f32>((bitcast<u32>(_e2775) & 2147483647u)) >= 1073741800f);
let _e2851 = ((_e2775 * select(1f, _e2780, _e2848)) + 0.5f);
let _e2853 = select(-1073741800f, _e2851, (_e2851 > -1073741800f));
let _e2855 = select(1073741800f, _e2853, (_e2853 < 1073741800f));
let _e2862 = select(0i, select(select(i32(_e2855), i32(-2147483648), (_e2855 < -2147483600f)), 2147483647i, (_e2855 > 2147483500f)), (_e2855 == _e2855));
let _e2866 = (_e2862 - select(0i, 1i, (_e2855 < f32(_e2862))));
let _e2867 = select(0i, 20i, _e2848);
let _e2871 = (bitcast<u32>(_e2866) << bitcast<u32>((_e2867 & 31i)));
let _e2878 = bitcast<u32>(((_e2866 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2867) & 31i))));
let _e2883 = bitcast<i32>(bitcast<u32>((((_e2762.member_1 * _e803) + _e2762.member) * 6i)));
if ((_e2803 | _e2810) == 0u) {
} else {
let _e2886 = bitcast<u32>(_e2883);
if (_e2886 < _e143) {
let _e2890 = atomicAdd((&global_6.member[_e2886]), _e2803);
phi_6157_ = _e2890;
} else {
phi_6157_ = 0u;
}
let _e2892 = phi_6157_;
let _e2896 = (_e2810 + select(0u, 1u, ((_e2892 + _e2803) < _e2803)));
if (_e2896 == 0u) {
} else {
let _e2898 = (_e2886 + 1u);
if (_e2898 < _e143) {
let _e2902 = atomicAdd((&global_6.member[_e2898]), _e2896);
}
}
}
if ((_e2837 | _e2844) == 0u) {
} else {
let _e2906 = bitcast<u32>((_e2883 + 2i));
if (_e2906 < _e143) {
let _e2910 = atomicAdd((&global_6.member[_e2906]), _e2837);
phi_6187_ = _e2910;
} else {
phi_6187_ = 0u;
}
let _e2912 = phi_6187_;
let _e2916 = (_e2844 + select(0u, 1u, ((_e2912 + _e2837) < _e2837)));
if (_e2916 == 0u) {
} else {
let _e2918 = (_e2906 + 1u);
if (_e2918 < _e143) {
let _e2922 = atomicAdd((&global_6.member[_e2918]), _e2916);
}
}
}
if ((_e2871 | _e2878) == 0u) {
} else {
let _e2926 = bitcast<u32>((_e2883 + 4i));
if (_e2926 < _e143) {
let _e2930 = atomicAdd((&global_6.member[_e2926]), _e2871);
phi_6217_ = _e2930;
} else {
phi_6217_ = 0u;
}
let _e2932 = phi_6217_;
let _e2936 = (_e2878 + select(0u, 1u, ((_e2932 + _e2871) < _e2871)));
if (_e2936 == 0u) {
} else {
let _e2938 = (_e2926 + 1u);
if (_e2938 < _e143) {
let _e2942 = atomicAdd((&global_6.member[_e2938]), _e2936);
}
}
}
phi_3159_ = (_e1659 + 1i);
} else {
phi_3159_ = i32();
}
let _e2945 = phi_3159_;
continue;
continuing {
phi_3158_ = _e2945;
break if !(_e1662);
}
}
phi_3005_ = (_e1566 + 1i);
} else {
phi_3005_ = i32();
}
let _e2949 = phi_3005_;
continue;
continuing {
phi_3004_ = _e2949;
break if !(_e1567);
}
}
} else {
phi_6262_ = 0i;
loop {
let _e2952 = phi_6262_;
let _e2953 = (_e2952 < 16i);
if _e2953 {
let _e2955 = (_e848 + (_e2952 & 15i));
let _e2957 = (f32(_e2955) + 0.5f);
let _e2959 = ((_e2957 * 1f) - 0.5f);
let _e2963 = (-(((_e289 * _e2959) + _e315)) / _e302);
let _e2970 = bitcast<f32>((bitcast<u32>(((_e339 * _e2959) + ((_e352 * _e2963) + _e365))) & 2147483647u));
let _e2977 = bitcast<f32>((bitcast<u32>(((_e378 * _e2959) + ((_e391 * _e2963) + _e404))) & 2147483647u));
let _e2981 = (((0.5f * (_e2970 + _e2977)) / _e407) + _e586);
let _e2982 = (1f / 1f);
let _e2990 = ((((_e2963 + _e2981) + 0.5f) * _e2982) - 0.5f);
let _e2991 = f32(_e853);
let _e2992 = (0f - 1f);
let _e2994 = select(_e2992, _e2990, (_e2990 > _e2992));
let _e2996 = select(_e2991, _e2994, (_e2994 < _e2991));
let _e3003 = select(0i, select(select(i32(_e2996), i32(-2147483648), (_e2996 < -2147483600f)), 2147483647i, (_e2996 > 2147483500f)), (_e2996 == _e2996));
let _e3008 = (((((_e2963 - _e2981) + 0.5f) * _e2982) - 0.5f) + 1f);
let _e3009 = (_e2991 + 1f);
let _e3011 = select(0f, _e3008, (_e3008 > 0f));
let _e3013 = select(_e3009, _e3011, (_e3011 < _e3009));
let _e3020 = select(0i, select(select(i32(_e3013), i32(-2147483648), (_e3013 < -2147483600f)), 2147483647i, (_e3013 > 2147483500f)), (_e3013 == _e3013));
let _e3031 = ((1e-4f * 1f) * _e407);
let _e3033 = select(_e2977, _e2970, (_e2970 > _e2977));
let _e3035 = select(_e3031, _e3033, (_e3033 > _e3031));
let _e3037 = select(_e2977, _e2970, (_e2970 < _e2977));
let _e3039 = select(_e3031, _e3037, (_e3037 > _e3031));
let _e3041 = (0.5f * (_e3035 + _e3039));
let _e3042 = (0.5f / _e3039);
let _e3043 = (1f / _e3035);
phi_6416_ = 0i;
loop {
let _e3045 = phi_6416_;
let _e3047 = (((_e3020 - select(0i, 1i, (_e3013 < f32(_e3020)))) + (_e2952 >> bitcast<u32>(4u))) + bitcast<i32>(_e3045));
let _e3048 = (_e3047 <= select(-1i, (_e3003 - select(0i, 1i, (_e2996 < f32(_e3003)))), (_e2955 <= _e852)));
if _e3048 {
let _e3050 = (f32(_e3047) + 0.5f);
let _e3054 = ((((_e3050 * 1f) - 0.5f) - _e2963) * _e407);
let _e3055 = (_e407 * 1f);
let _e3057 = (0.5f * _e3055);
let _e3058 = (_e3054 + _e3057);
let _e3059 = -(_e3058);
let _e3062 = (_e3041 - select(_e3059, _e3058, (_e3058 > _e3059)));
let _e3064 = select(0f, _e3062, (_e3062 > 0f));
let _e3066 = select(_e3039, _e3064, (_e3064 < _e3039));
let _e3069 = (_e3062 - _e3039);
let _e3073 = (((_e3066 * (_e3066 * _e3042)) + select(0f, _e3069, (_e3069 > 0f))) * _e3043);
let _e3077 = (_e3054 - _e3057);
let _e3078 = -(_e3077);
let _e3081 = (_e3041 - select(_e3078, _e3077, (_e3077 > _e3078)));
let _e3083 = select(0f, _e3081, (_e3081 > 0f));
let _e3085 = select(_e3039, _e3083, (_e3083 < _e3039));
let _e3088 = (_e3081 - _e3039);
let _e3092 = (((_e3085 * (_e3085 * _e3042)) + select(0f, _e3088, (_e3088 > 0f))) * _e3043);
if _e326 {
phi_6521_ = type_23(_e3047, _e2955);
} else {
phi_6521_ = type_23(_e2955, _e3047);
}
let _e3101 = phi_6521_;
let _e3107 = ((_e3101.member_1 * _e803) + _e3101.member);
let _e3109 = (bitcast<i32>(_e138) - 1i);
let _e3111 = select(_e3109, _e3107, (_e3107 < _e3109));
let _e3116 = global_4.member[bitcast<u32>(select(0i, _e3111, (_e3111 > 0i)))];
let _e3117 = (bitcast<i32>((_e799 * _e802)) + _e3107);
let _e3119 = select(_e3109, _e3117, (_e3117 < _e3109));
let _e3124 = global_4.member[bitcast<u32>(select(0i, _e3119, (_e3119 > 0i)))];
let _e3127 = f32(_e803);
let _e3128 = f32(_e804);
let _e3135 = global_1.member.member_2.member;
let _e3136 = (((((f32(_e3101.member) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e3143 = global_1.member.member_2.member_1;
let _e3144 = ((1f - (((f32(_e3101.member_1) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e3146 = global_1.member.member_3;
let _e3154 = global_1.member.member_4;
let _e3161 = ((_e3146.member * _e3136) + (_e3154.member * _e3144));
let _e3162 = ((_e3146.member_1 * _e3136) + (_e3154.member_1 * _e3144));
let _e3163 = ((_e3146.member_2 * _e3136) + (_e3154.member_2 * _e3144));
let _e3166 = global_1.member.member_2.member_3;
let _e3167 = (_e3166 != 0u);
let _e3169 = global_1.member.member_5;
let _e3176 = select((_e3169.member + _e3161), _e3169.member, _e3167);
let _e3177 = select((_e3169.member_1 + _e3162), _e3169.member_1, _e3167);
let _e3178 = select((_e3169.member_2 + _e3163), _e3169.member_2, _e3167);
let _e3180 = global_1.member.member_6;
let _e3194 = (((_e3176 * _e3176) + (_e3177 * _e3177)) + (_e3178 * _e3178));
let _e3197 = sqrt(select(0f, _e3194, (_e3194 > 0f)));
let _e3198 = (1f / _e3197);
let _e3199 = (_e3176 * _e3198);
let _e3200 = (_e3177 * _e3198);
let _e3201 = (_e3178 * _e3198);
let _e3202 = (_e444 - select(_e3180.member, (_e3180.member + _e3161), _e3167));
let _e3203 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e3162), _e3167));
let _e3204 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e3163), _e3167));
let _e3209 = (((_e3202 * _e3199) + (_e3203 * _e3200)) + (_e3204 * _e3201));
let _e3214 = (((_e3202 * _e482) + (_e3203 * _e495)) + (_e3204 * _e508));
let _e3219 = (((_e3199 * _e482) + (_e3200 * _e495)) + (_e3201 * _e508));
let _e3222 = ((_e3200 * _e508) - (_e3201 * _e495));
let _e3225 = ((_e3201 * _e482) - (_e3199 * _e508));
let _e3228 = ((_e3199 * _e495) - (_e3200 * _e482));
let _e3233 = (((_e3222 * _e3222) + (_e3225 * _e3225)) + (_e3228 * _e3228));
let _e3236 = (1f / select(1e-9f, _e3233, (_e3233 > 1e-9f)));
let _e3239 = ((_e3209 - (_e3219 * _e3214)) * _e3236);
let _e3242 = (((_e3219 * _e3209) - _e3214) * _e3236);
let _e3248 = (_e3239 - _e3124);
let _e3251 = (_e3242 + select(0f, _e3248, (_e3248 > 0f)));
let _e3254 = global_1.member.member_13.member;
let _e3259 = -((_e3254.member * _e3251));
let _e3261 = select(-87f, _e3259, (_e3259 > -87f));
let _e3263 = select(88f, _e3261, (_e3261 < 88f));
let _e3265 = ((_e3263 * 1.442695f) + 0.5f);
let _e3267 = select(-127f, _e3265, (_e3265 > -127f));
let _e3269 = select(128f, _e3267, (_e3267 < 128f));
let _e3276 = select(0i, select(select(i32(_e3269), i32(-2147483648), (_e3269 < -2147483600f)), 2147483647i, (_e3269 > 2147483500f)), (_e3269 == _e3269));
let _e3280 = (_e3276 - select(0i, 1i, (_e3269 < f32(_e3276))));
let _e3281 = f32(_e3280);
let _e3285 = ((_e3263 - (_e3281 * 0.6933594f)) - (_e3281 * -2.1219444e-4f));
let _e3307 = -((_e3254.member_1 * _e3251));
let _e3309 = select(-87f, _e3307, (_e3307 > -87f));
let _e3311 = select(88f, _e3309, (_e3309 < 88f));
let _e3313 = ((_e3311 * 1.442695f) + 0.5f);
let _e3315 = select(-127f, _e3313, (_e3313 > -127f));
let _e3317 = select(128f, _e3315, (_e3315 < 128f));
let _e3324 = select(0i, select(select(i32(_e3317), i32(-2147483648), (_e3317 < -2147483600f)), 2147483647i, (_e3317 > 2147483500f)), (_e3317 == _e3317));
let _e3328 = (_e3324 - select(0i, 1i, (_e3317 < f32(_e3324))));
let _e3329 = f32(_e3328);
let _e3333 = ((_e3311 - (_e3329 * 0.6933594f)) - (_e3329 * -2.1219444e-4f));
let _e3355 = -((_e3254.member_2 * _e3251));
let _e3357 = select(-87f, _e3355, (_e3355 > -87f));
let _e3359 = select(88f, _e3357, (_e3357 < 88f));
let _e3361 = ((_e3359 * 1.442695f) + 0.5f);
let _e3363 = select(-127f, _e3361, (_e3361 > -127f));
let _e3365 = select(128f, _e3363, (_e3363 < 128f));
let _e3372 = select(0i, select(select(i32(_e3365), i32(-2147483648), (_e3365 < -2147483600f)), 2147483647i, (_e3365 > 2147483500f)), (_e3365 == _e3365));
let _e3376 = (_e3372 - select(0i, 1i, (_e3365 < f32(_e3372))));
let _e3377 = f32(_e3376);
let _e3381 = ((_e3359 - (_e3377 * 0.6933594f)) - (_e3377 * -2.1219444e-4f));
let _e3402 = -(_e3219);
let _e3405 = global_1.member.member_13.member_2;
let _e3406 = (_e3405 * _e3405);
let _e3410 = ((1f + _e3406) - ((2f * _e3405) * _e3402));
let _e3412 = select(1e-9f, _e3410, (_e3410 > 1e-9f));
let _e3424 = global_1.member.member_13.member_3;
let _e3429 = (_e3197 * (select(((1f - _e3406) / (_e3412 * sqrt(select(0f, _e3412, (_e3412 > 0f))))), (0.75f * (1f + (_e3402 * _e3402))), (_e3424 == 1u)) * (0.25f / 3.1415927f)));
let _e3432 = global_1.member.member_13.member_1;
let _e3445 = select(0f, _e3239, (((_e3242 >= 0f) && (_e3242 < _e560)) && (_e3239 > 0f)));
let _e3446 = (_e635 & 31u);
let _e3448 = (1u << bitcast<u32>(_e3446));
let _e3457 = bitcast<i32>((((_e799 + _e3448) - 1u) >> bitcast<u32>(_e3446)));
let _e3458 = bitcast<i32>((((_e802 + _e3448) - 1u) >> bitcast<u32>(_e3446)));
if _e326 {
phi_7065_ = type_23(_e3458, _e3457);
} else {
phi_7065_ = type_23(_e3457, _e3458);
}
let _e3462 = phi_7065_;
let _e3467 = f32((1i << bitcast<u32>(_e3446)));
let _e3468 = (1f / _e3467);
let _e3470 = ((_e2957 * _e3468) - 0.5f);
let _e3472 = ((_e3050 * _e3468) - 0.5f);
let _e3474 = select(-1f, _e3470, (_e3470 > -1f));
let _e3476 = select(1e6f, _e3474, (_e3474 < 1e6f));
let _e3483 = select(0i, select(select(i32(_e3476), i32(-2147483648), (_e3476 < -2147483600f)), 2147483647i, (_e3476 > 2147483500f)), (_e3476 == _e3476));
let _e3487 = (_e3483 - select(0i, 1i, (_e3476 < f32(_e3483))));
let _e3489 = select(-1f, _e3472, (_e3472 > -1f));
let _e3491 = select(1e6f, _e3489, (_e3489 < 1e6f));
let _e3498 = select(0i, select(select(i32(_e3491), i32(-2147483648), (_e3491 < -2147483600f)), 2147483647i, (_e3491 > 2147483500f)), (_e3491 == _e3491));
let _e3502 = (_e3498 - select(0i, 1i, (_e3491 < f32(_e3498))));
let _e3504 = (_e3470 - f32(_e3487));
let _e3506 = (_e3472 - f32(_e3502));
let _e3507 = (1f - _e3504);
let _e3508 = (1f - _e3506);
let _e3511 = select(_e3487, 0i, (_e3487 < 0i));
let _e3512 = (_e3511 >= _e3462.member);
if _e3512 {
phi_7143_ = (_e3462.member - 1i);
} else {
phi_7143_ = _e3511;
}
let _e3515 = phi_7143_;
let _e3517 = select(_e3502, 0i, (_e3502 < 0i));
let _e3518 = (_e3517 >= _e3462.member_1);
if _e3518 {
phi_7154_ = (_e3462.member_1 - 1i);
} else {
phi_7154_ = _e3517;
}
let _e3521 = phi_7154_;
let _e3525 = (((f32(_e3515) + 0.5f) * _e3467) - 0.5f);
let _e3529 = (((f32(_e3521) + 0.5f) * _e3467) - 0.5f);
if _e326 {
phi_7182_ = type_23(_e3521, _e3515);
} else {
phi_7182_ = type_23(_e3515, _e3521);
}
let _e3535 = phi_7182_;
let _e3541 = bitcast<i32>(((_e799 + 1u) >> bitcast<u32>(1u)));
let _e3544 = global_1.member.member_18.member_6;
let _e3547 = global_1.member.member_18.member_7;
let _e3550 = global_1.member.member_18.member_8;
if _e854 {
phi_7233_ = 0u;
} else {
if (_e635 == 1u) {
phi_7232_ = 0u;
} else {
if (_e635 == 2u) {
phi_7231_ = _e3544;
} else {
phi_7231_ = select(_e3550, _e3547, (_e635 == 3u));
}
let _e3556 = phi_7231_;
phi_7232_ = _e3556;
}
let _e3558 = phi_7232_;
phi_7233_ = _e3558;
}
let _e3560 = phi_7233_;
local_56 = (((bitcast<i32>(_e3560) + _e3535.member_1) * _e3541) + _e3535.member);
let _e3565 = local_56;
let _e3567 = (bitcast<i32>(_e141) - 1i);
let _e3569 = select(_e3567, _e3565, (_e3565 < _e3567));
let _e3574 = global_5.member[bitcast<u32>(select(0i, _e3569, (_e3569 > 0i)))];
let _e3579 = (((((select(_e3525, _e3529, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e3584 = ((1f - (((select(_e3529, _e3525, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e3591 = ((_e3146.member * _e3579) + (_e3154.member * _e3584));
let _e3592 = ((_e3146.member_1 * _e3579) + (_e3154.member_1 * _e3584));
let _e3593 = ((_e3146.member_2 * _e3579) + (_e3154.member_2 * _e3584));
let _e3597 = select((_e3169.member + _e3591), _e3169.member, _e3167);
let _e3598 = select((_e3169.member_1 + _e3592), _e3169.member_1, _e3167);
let _e3599 = select((_e3169.member_2 + _e3593), _e3169.member_2, _e3167);
let _e3610 = (((_e3597 * _e3597) + (_e3598 * _e3598)) + (_e3599 * _e3599));
let _e3614 = (1f / sqrt(select(0f, _e3610, (_e3610 > 0f))));
let _e3615 = (_e3597 * _e3614);
let _e3616 = (_e3598 * _e3614);
let _e3617 = (_e3599 * _e3614);
let _e3618 = (_e444 - select(_e3180.member, (_e3180.member + _e3591), _e3167));
let _e3619 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e3592), _e3167));
let _e3620 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e3593), _e3167));
let _e3625 = (((_e3618 * _e3615) + (_e3619 * _e3616)) + (_e3620 * _e3617));
let _e3630 = (((_e3618 * _e482) + (_e3619 * _e495)) + (_e3620 * _e508));
let _e3635 = (((_e3615 * _e482) + (_e3616 * _e495)) + (_e3617 * _e508));
let _e3638 = ((_e3616 * _e508) - (_e3617 * _e495));
let _e3641 = ((_e3617 * _e482) - (_e3615 * _e508));
let _e3644 = ((_e3615 * _e495) - (_e3616 * _e482));
let _e3649 = (((_e3638 * _e3638) + (_e3641 * _e3641)) + (_e3644 * _e3644));
let _e3652 = (1f / select(1e-9f, _e3649, (_e3649 > 1e-9f)));
let _e3655 = ((_e3625 - (_e3635 * _e3630)) * _e3652);
let _e3658 = (((_e3635 * _e3625) - _e3630) * _e3652);
let _e3664 = select(0f, _e3655, (((_e3658 >= 0f) && (_e3658 < _e560)) && (_e3655 > 0f)));
let _e3666 = (_e3515 << bitcast<u32>(_e3446));
let _e3678 = (_e3487 + 1i);
let _e3681 = select(_e3678, 0i, (_e3678 < 0i));
let _e3682 = (_e3681 >= _e3462.member);
if _e3682 {
phi_7650_ = (_e3462.member - 1i);
} else {
phi_7650_ = _e3681;
}
let _e3685 = phi_7650_;
if _e3518 {
phi_7661_ = (_e3462.member_1 - 1i);
} else {
phi_7661_ = _e3517;
}
let _e3688 = phi_7661_;
let _e3692 = (((f32(_e3685) + 0.5f) * _e3467) - 0.5f);
let _e3696 = (((f32(_e3688) + 0.5f) * _e3467) - 0.5f);
if _e326 {
phi_7689_ = type_23(_e3688, _e3685);
} else {
phi_7689_ = type_23(_e3685, _e3688);
}
let _e3702 = phi_7689_;
if _e854 {
phi_7740_ = 0u;
} else {
if (_e635 == 1u) {
phi_7739_ = 0u;
} else {
if (_e635 == 2u) {
phi_7738_ = _e3544;
} else {
phi_7738_ = select(_e3550, _e3547, (_e635 == 3u));
}
let _e3710 = phi_7738_;
phi_7739_ = _e3710;
}
let _e3712 = phi_7739_;
phi_7740_ = _e3712;
}
let _e3714 = phi_7740_;
local_54 = (((bitcast<i32>(_e3714) + _e3702.member_1) * _e3541) + _e3702.member);
let _e3719 = local_54;
let _e3721 = select(_e3567, _e3719, (_e3719 < _e3567));
let _e3726 = global_5.member[bitcast<u32>(select(0i, _e3721, (_e3721 > 0i)))];
let _e3731 = (((((select(_e3692, _e3696, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e3736 = ((1f - (((select(_e3696, _e3692, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e3743 = ((_e3146.member * _e3731) + (_e3154.member * _e3736));
let _e3744 = ((_e3146.member_1 * _e3731) + (_e3154.member_1 * _e3736));
let _e3745 = ((_e3146.member_2 * _e3731) + (_e3154.member_2 * _e3736));
let _e3749 = select((_e3169.member + _e3743), _e3169.member, _e3167);
let _e3750 = select((_e3169.member_1 + _e3744), _e3169.member_1, _e3167);
let _e3751 = select((_e3169.member_2 + _e3745), _e3169.member_2, _e3167);
let _e3762 = (((_e3749 * _e3749) + (_e3750 * _e3750)) + (_e3751 * _e3751));
let _e3766 = (1f / sqrt(select(0f, _e3762, (_e3762 > 0f))));
let _e3767 = (_e3749 * _e3766);
let _e3768 = (_e3750 * _e3766);
let _e3769 = (_e3751 * _e3766);
let _e3770 = (_e444 - select(_e3180.member, (_e3180.member + _e3743), _e3167));
let _e3771 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e3744), _e3167));
let _e3772 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e3745), _e3167));
let _e3777 = (((_e3770 * _e3767) + (_e3771 * _e3768)) + (_e3772 * _e3769));
let _e3782 = (((_e3770 * _e482) + (_e3771 * _e495)) + (_e3772 * _e508));
let _e3787 = (((_e3767 * _e482) + (_e3768 * _e495)) + (_e3769 * _e508));
let _e3790 = ((_e3768 * _e508) - (_e3769 * _e495));
let _e3793 = ((_e3769 * _e482) - (_e3767 * _e508));
let _e3796 = ((_e3767 * _e495) - (_e3768 * _e482));
let _e3801 = (((_e3790 * _e3790) + (_e3793 * _e3793)) + (_e3796 * _e3796));
let _e3804 = (1f / select(1e-9f, _e3801, (_e3801 > 1e-9f)));
let _e3807 = ((_e3777 - (_e3787 * _e3782)) * _e3804);
let _e3810 = (((_e3787 * _e3777) - _e3782) * _e3804);
let _e3816 = select(0f, _e3807, (((_e3810 >= 0f) && (_e3810 < _e560)) && (_e3807 > 0f)));
let _e3818 = (_e3685 << bitcast<u32>(_e3446));
let _e3830 = (_e3502 + 1i);
if _e3512 {
phi_8157_ = (_e3462.member - 1i);
} else {
phi_8157_ = _e3511;
}
let _e3834 = phi_8157_;
let _e3836 = select(_e3830, 0i, (_e3830 < 0i));
let _e3837 = (_e3836 >= _e3462.member_1);
if _e3837 {
phi_8168_ = (_e3462.member_1 - 1i);
} else {
phi_8168_ = _e3836;
}
let _e3840 = phi_8168_;
let _e3844 = (((f32(_e3834) + 0.5f) * _e3467) - 0.5f);
let _e3848 = (((f32(_e3840) + 0.5f) * _e3467) - 0.5f);
if _e326 {
phi_8196_ = type_23(_e3840, _e3834);
} else {
phi_8196_ = type_23(_e3834, _e3840);
}
let _e3854 = phi_8196_;
if _e854 {
phi_8247_ = 0u;
} else {
if (_e635 == 1u) {
phi_8246_ = 0u;
} else {
if (_e635 == 2u) {
phi_8245_ = _e3544;
} else {
phi_8245_ = select(_e3550, _e3547, (_e635 == 3u));
}
let _e3862 = phi_8245_;
phi_8246_ = _e3862;
}
let _e3864 = phi_8246_;
phi_8247_ = _e3864;
}
let _e3866 = phi_8247_;
local_52 = (((bitcast<i32>(_e3866) + _e3854.member_1) * _e3541) + _e3854.member);
let _e3871 = local_52;
let _e3873 = select(_e3567, _e3871, (_e3871 < _e3567));
let _e3878 = global_5.member[bitcast<u32>(select(0i, _e3873, (_e3873 > 0i)))];
let _e3883 = (((((select(_e3844, _e3848, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e3888 = ((1f - (((select(_e3848, _e3844, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e3895 = ((_e3146.member * _e3883) + (_e3154.member * _e3888));
let _e3896 = ((_e3146.member_1 * _e3883) + (_e3154.member_1 * _e3888));
let _e3897 = ((_e3146.member_2 * _e3883) + (_e3154.member_2 * _e3888));
let _e3901 = select((_e3169.member + _e3895), _e3169.member, _e3167);
let _e3902 = select((_e3169.member_1 + _e3896), _e3169.member_1, _e3167);
let _e3903 = select((_e3169.member_2 + _e3897), _e3169.member_2, _e3167);
let _e3914 = (((_e3901 * _e3901) + (_e3902 * _e3902)) + (_e3903 * _e3903));
let _e3918 = (1f / sqrt(select(0f, _e3914, (_e3914 > 0f))));
let _e3919 = (_e3901 * _e3918);
let _e3920 = (_e3902 * _e3918);
let _e3921 = (_e3903 * _e3918);
let _e3922 = (_e444 - select(_e3180.member, (_e3180.member + _e3895), _e3167));
let _e3923 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e3896), _e3167));
let _e3924 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e3897), _e3167));
let _e3929 = (((_e3922 * _e3919) + (_e3923 * _e3920)) + (_e3924 * _e3921));
let _e3934 = (((_e3922 * _e482) + (_e3923 * _e495)) + (_e3924 * _e508));
let _e3939 = (((_e3919 * _e482) + (_e3920 * _e495)) + (_e3921 * _e508));
let _e3942 = ((_e3920 * _e508) - (_e3921 * _e495));
let _e3945 = ((_e3921 * _e482) - (_e3919 * _e508));
let _e3948 = ((_e3919 * _e495) - (_e3920 * _e482));
let _e3953 = (((_e3942 * _e3942) + (_e3945 * _e3945)) + (_e3948 * _e3948));
let _e3956 = (1f / select(1e-9f, _e3953, (_e3953 > 1e-9f)));
let _e3959 = ((_e3929 - (_e3939 * _e3934)) * _e3956);
let _e3962 = (((_e3939 * _e3929) - _e3934) * _e3956);
let _e3968 = select(0f, _e3959, (((_e3962 >= 0f) && (_e3962 < _e560)) && (_e3959 > 0f)));
let _e3970 = (_e3834 << bitcast<u32>(_e3446));
if _e3682 {
phi_8664_ = (_e3462.member - 1i);
} else {
phi_8664_ = _e3681;
}
let _e3985 = phi_8664_;
if _e3837 {
phi_8675_ = (_e3462.member_1 - 1i);
} else {
phi_8675_ = _e3836;
}
let _e3988 = phi_8675_;
let _e3992 = (((f32(_e3985) + 0.5f) * _e3467) - 0.5f);
let _e3996 = (((f32(_e3988) + 0.5f) * _e3467) - 0.5f);
if _e326 {
phi_8703_ = type_23(_e3988, _e3985);
} else {
phi_8703_ = type_23(_e3985, _e3988);
}
let _e4002 = phi_8703_;
if _e854 {
phi_8754_ = 0u;
} else {
if (_e635 == 1u) {
phi_8753_ = 0u;
} else {
if (_e635 == 2u) {
phi_8752_ = _e3544;
} else {
phi_8752_ = select(_e3550, _e3547, (_e635 == 3u));
}
let _e4010 = phi_8752_;
phi_8753_ = _e4010;
}
let _e4012 = phi_8753_;
phi_8754_ = _e4012;
}
let _e4014 = phi_8754_;
local_50 = (((bitcast<i32>(_e4014) + _e4002.member_1) * _e3541) + _e4002.member);
let _e4019 = local_50;
let _e4021 = select(_e3567, _e4019, (_e4019 < _e3567));
let _e4026 = global_5.member[bitcast<u32>(select(0i, _e4021, (_e4021 > 0i)))];
let _e4031 = (((((select(_e3992, _e3996, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e4036 = ((1f - (((select(_e3996, _e3992, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e4043 = ((_e3146.member * _e4031) + (_e3154.member * _e4036));
let _e4044 = ((_e3146.member_1 * _e4031) + (_e3154.member_1 * _e4036));
let _e4045 = ((_e3146.member_2 * _e4031) + (_e3154.member_2 * _e4036));
let _e4049 = select((_e3169.member + _e4043), _e3169.member, _e3167);
let _e4050 = select((_e3169.member_1 + _e4044), _e3169.member_1, _e3167);
let _e4051 = select((_e3169.member_2 + _e4045), _e3169.member_2, _e3167);
let _e4062 = (((_e4049 * _e4049) + (_e4050 * _e4050)) + (_e4051 * _e4051));
let _e4066 = (1f / sqrt(select(0f, _e4062, (_e4062 > 0f))));
let _e4067 = (_e4049 * _e4066);
let _e4068 = (_e4050 * _e4066);
let _e4069 = (_e4051 * _e4066);
let _e4070 = (_e444 - select(_e3180.member, (_e3180.member + _e4043), _e3167));
let _e4071 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e4044), _e3167));
let _e4072 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e4045), _e3167));
let _e4077 = (((_e4070 * _e4067) + (_e4071 * _e4068)) + (_e4072 * _e4069));
let _e4082 = (((_e4070 * _e482) + (_e4071 * _e495)) + (_e4072 * _e508));
let _e4087 = (((_e4067 * _e482) + (_e4068 * _e495)) + (_e4069 * _e508));
let _e4090 = ((_e4068 * _e508) - (_e4069 * _e495));
let _e4093 = ((_e4069 * _e482) - (_e4067 * _e508));
let _e4096 = ((_e4067 * _e495) - (_e4068 * _e482));
let _e4101 = (((_e4090 * _e4090) + (_e4093 * _e4093)) + (_e4096 * _e4096));
let _e4104 = (1f / select(1e-9f, _e4101, (_e4101 > 1e-9f)));
let _e4107 = ((_e4077 - (_e4087 * _e4082)) * _e4104);
let _e4110 = (((_e4087 * _e4077) - _e4082) * _e4104);
let _e4116 = select(0f, _e4107, (((_e4110 >= 0f) && (_e4110 < _e560)) && (_e4107 > 0f)));
let _e4118 = (_e3985 << bitcast<u32>(_e3446));
let _e4130 = select(((((1f - select(0f, (_e3507 * _e3508), (((select(select(_e635, _e796, (_e3666 >= _e561)), _e716, (_e3666 < _e171)) == _e635) && (_e3664 > 0f)) && (_e3664 < _e3574)))) - select(0f, (_e3504 * _e3508), (((select(select(_e635, _e796, (_e3818 >= _e561)), _e716, (_e3818 < _e171)) == _e635) && (_e3816 > 0f)) && (_e3816 < _e3726)))) - select(0f, (_e3507 * _e3506), (((select(select(_e635, _e796, (_e3970 >= _e561)), _e716, (_e3970 < _e171)) == _e635) && (_e3968 > 0f)) && (_e3968 < _e3878)))) - select(0f, (_e3504 * _e3506), (((select(select(_e635, _e796, (_e4118 >= _e561)), _e716, (_e4118 < _e171)) == _e635) && (_e4116 > 0f)) && (_e4116 < _e4026)))), 1f, _e854);
let _e4131 = (_e856 & 31u);
let _e4133 = (1u << bitcast<u32>(_e4131));
let _e4142 = bitcast<i32>((((_e799 + _e4133) - 1u) >> bitcast<u32>(_e4131)));
let _e4143 = bitcast<i32>((((_e802 + _e4133) - 1u) >> bitcast<u32>(_e4131)));
if _e326 {
phi_9189_ = type_23(_e4143, _e4142);
} else {
phi_9189_ = type_23(_e4142, _e4143);
}
let _e4147 = phi_9189_;
let _e4152 = f32((1i << bitcast<u32>(_e4131)));
let _e4153 = (1f / _e4152);
let _e4155 = ((_e2957 * _e4153) - 0.5f);
let _e4157 = ((_e3050 * _e4153) - 0.5f);
let _e4159 = select(-1f, _e4155, (_e4155 > -1f));
let _e4161 = select(1e6f, _e4159, (_e4159 < 1e6f));
let _e4168 = select(0i, select(select(i32(_e4161), i32(-2147483648), (_e4161 < -2147483600f)), 2147483647i, (_e4161 > 2147483500f)), (_e4161 == _e4161));
let _e4172 = (_e4168 - select(0i, 1i, (_e4161 < f32(_e4168))));
let _e4174 = select(-1f, _e4157, (_e4157 > -1f));
let _e4176 = select(1e6f, _e4174, (_e4174 < 1e6f));
let _e4183 = select(0i, select(select(i32(_e4176), i32(-2147483648), (_e4176 < -2147483600f)), 2147483647i, (_e4176 > 2147483500f)), (_e4176 == _e4176));
let _e4187 = (_e4183 - select(0i, 1i, (_e4176 < f32(_e4183))));
let _e4189 = (_e4155 - f32(_e4172));
let _e4191 = (_e4157 - f32(_e4187));
let _e4192 = (1f - _e4189);
let _e4193 = (1f - _e4191);
let _e4196 = select(_e4172, 0i, (_e4172 < 0i));
let _e4197 = (_e4196 >= _e4147.member);
if _e4197 {
phi_9267_ = (_e4147.member - 1i);
} else {
phi_9267_ = _e4196;
}
let _e4200 = phi_9267_;
let _e4202 = select(_e4187, 0i, (_e4187 < 0i));
let _e4203 = (_e4202 >= _e4147.member_1);
if _e4203 {
phi_9278_ = (_e4147.member_1 - 1i);
} else {
phi_9278_ = _e4202;
}
let _e4206 = phi_9278_;
let _e4210 = (((f32(_e4200) + 0.5f) * _e4152) - 0.5f);
let _e4214 = (((f32(_e4206) + 0.5f) * _e4152) - 0.5f);
if _e326 {
phi_9306_ = type_23(_e4206, _e4200);
} else {
phi_9306_ = type_23(_e4200, _e4206);
}
let _e4220 = phi_9306_;
let _e4223 = (_e856 == 0u);
if _e4223 {
phi_9357_ = 0u;
} else {
if (_e856 == 1u) {
phi_9356_ = 0u;
} else {
if (_e856 == 2u) {
phi_9355_ = _e3544;
} else {
phi_9355_ = select(_e3550, _e3547, (_e856 == 3u));
}
let _e4229 = phi_9355_;
phi_9356_ = _e4229;
}
let _e4231 = phi_9356_;
phi_9357_ = _e4231;
}
let _e4233 = phi_9357_;
local_48 = (((bitcast<i32>(_e4233) + _e4220.member_1) * _e3541) + _e4220.member);
let _e4238 = local_48;
let _e4240 = select(_e3567, _e4238, (_e4238 < _e3567));
let _e4245 = global_5.member[bitcast<u32>(select(0i, _e4240, (_e4240 > 0i)))];
let _e4250 = (((((select(_e4210, _e4214, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e4255 = ((1f - (((select(_e4214, _e4210, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e4262 = ((_e3146.member * _e4250) + (_e3154.member * _e4255));
let _e4263 = ((_e3146.member_1 * _e4250) + (_e3154.member_1 * _e4255));
let _e4264 = ((_e3146.member_2 * _e4250) + (_e3154.member_2 * _e4255));
let _e4268 = select((_e3169.member + _e4262), _e3169.member, _e3167);
let _e4269 = select((_e3169.member_1 + _e4263), _e3169.member_1, _e3167);
let _e4270 = select((_e3169.member_2 + _e4264), _e3169.member_2, _e3167);
let _e4281 = (((_e4268 * _e4268) + (_e4269 * _e4269)) + (_e4270 * _e4270));
let _e4285 = (1f / sqrt(select(0f, _e4281, (_e4281 > 0f))));
let _e4286 = (_e4268 * _e4285);
let _e4287 = (_e4269 * _e4285);
let _e4288 = (_e4270 * _e4285);
let _e4289 = (_e444 - select(_e3180.member, (_e3180.member + _e4262), _e3167));
let _e4290 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e4263), _e3167));
let _e4291 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e4264), _e3167));
let _e4296 = (((_e4289 * _e4286) + (_e4290 * _e4287)) + (_e4291 * _e4288));
let _e4301 = (((_e4289 * _e482) + (_e4290 * _e495)) + (_e4291 * _e508));
let _e4306 = (((_e4286 * _e482) + (_e4287 * _e495)) + (_e4288 * _e508));
let _e4309 = ((_e4287 * _e508) - (_e4288 * _e495));
let _e4312 = ((_e4288 * _e482) - (_e4286 * _e508));
let _e4315 = ((_e4286 * _e495) - (_e4287 * _e482));
let _e4320 = (((_e4309 * _e4309) + (_e4312 * _e4312)) + (_e4315 * _e4315));
let _e4323 = (1f / select(1e-9f, _e4320, (_e4320 > 1e-9f)));
let _e4326 = ((_e4296 - (_e4306 * _e4301)) * _e4323);
let _e4329 = (((_e4306 * _e4296) - _e4301) * _e4323);
let _e4335 = select(0f, _e4326, (((_e4329 >= 0f) && (_e4329 < _e560)) && (_e4326 > 0f)));
let _e4337 = (_e4200 << bitcast<u32>(_e4131));
let _e4349 = (_e4172 + 1i);
let _e4352 = select(_e4349, 0i, (_e4349 < 0i));
let _e4353 = (_e4352 >= _e4147.member);
if _e4353 {
phi_9774_ = (_e4147.member - 1i);
} else {
phi_9774_ = _e4352;
}
let _e4356 = phi_9774_;
if _e4203 {
phi_9785_ = (_e4147.member_1 - 1i);
} else {
phi_9785_ = _e4202;
}
let _e4359 = phi_9785_;
let _e4363 = (((f32(_e4356) + 0.5f) * _e4152) - 0.5f);
let _e4367 = (((f32(_e4359) + 0.5f) * _e4152) - 0.5f);
if _e326 {
phi_9813_ = type_23(_e4359, _e4356);
} else {
phi_9813_ = type_23(_e4356, _e4359);
}
let _e4373 = phi_9813_;
if _e4223 {
phi_9864_ = 0u;
} else {
if (_e856 == 1u) {
phi_9863_ = 0u;
} else {
if (_e856 == 2u) {
phi_9862_ = _e3544;
} else {
phi_9862_ = select(_e3550, _e3547, (_e856 == 3u));
}
let _e4381 = phi_9862_;
phi_9863_ = _e4381;
}
let _e4383 = phi_9863_;
phi_9864_ = _e4383;
}
let _e4385 = phi_9864_;
local_46 = (((bitcast<i32>(_e4385) + _e4373.member_1) * _e3541) + _e4373.member);
let _e4390 = local_46;
let _e4392 = select(_e3567, _e4390, (_e4390 < _e3567));
let _e4397 = global_5.member[bitcast<u32>(select(0i, _e4392, (_e4392 > 0i)))];
let _e4402 = (((((select(_e4363, _e4367, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e4407 = ((1f - (((select(_e4367, _e4363, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e4414 = ((_e3146.member * _e4402) + (_e3154.member * _e4407));
let _e4415 = ((_e3146.member_1 * _e4402) + (_e3154.member_1 * _e4407));
let _e4416 = ((_e3146.member_2 * _e4402) + (_e3154.member_2 * _e4407));
let _e4420 = select((_e3169.member + _e4414), _e3169.member, _e3167);
let _e4421 = select((_e3169.member_1 + _e4415), _e3169.member_1, _e3167);
let _e4422 = select((_e3169.member_2 + _e4416), _e3169.member_2, _e3167);
let _e4433 = (((_e4420 * _e4420) + (_e4421 * _e4421)) + (_e4422 * _e4422));
let _e4437 = (1f / sqrt(select(0f, _e4433, (_e4433 > 0f))));
let _e4438 = (_e4420 * _e4437);
let _e4439 = (_e4421 * _e4437);
let _e4440 = (_e4422 * _e4437);
let _e4441 = (_e444 - select(_e3180.member, (_e3180.member + _e4414), _e3167));
let _e4442 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e4415), _e3167));
let _e4443 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e4416), _e3167));
let _e4448 = (((_e4441 * _e4438) + (_e4442 * _e4439)) + (_e4443 * _e4440));
let _e4453 = (((_e4441 * _e482) + (_e4442 * _e495)) + (_e4443 * _e508));
let _e4458 = (((_e4438 * _e482) + (_e4439 * _e495)) + (_e4440 * _e508));
let _e4461 = ((_e4439 * _e508) - (_e4440 * _e495));
let _e4464 = ((_e4440 * _e482) - (_e4438 * _e508));
let _e4467 = ((_e4438 * _e495) - (_e4439 * _e482));
let _e4472 = (((_e4461 * _e4461) + (_e4464 * _e4464)) + (_e4467 * _e4467));
let _e4475 = (1f / select(1e-9f, _e4472, (_e4472 > 1e-9f)));
let _e4478 = ((_e4448 - (_e4458 * _e4453)) * _e4475);
let _e4481 = (((_e4458 * _e4448) - _e4453) * _e4475);
let _e4487 = select(0f, _e4478, (((_e4481 >= 0f) && (_e4481 < _e560)) && (_e4478 > 0f)));
let _e4489 = (_e4356 << bitcast<u32>(_e4131));
let _e4501 = (_e4187 + 1i);
if _e4197 {
phi_10281_ = (_e4147.member - 1i);
} else {
phi_10281_ = _e4196;
}
let _e4505 = phi_10281_;
let _e4507 = select(_e4501, 0i, (_e4501 < 0i));
let _e4508 = (_e4507 >= _e4147.member_1);
if _e4508 {
phi_10292_ = (_e4147.member_1 - 1i);
} else {
phi_10292_ = _e4507;
}
let _e4511 = phi_10292_;
let _e4515 = (((f32(_e4505) + 0.5f) * _e4152) - 0.5f);
let _e4519 = (((f32(_e4511) + 0.5f) * _e4152) - 0.5f);
if _e326 {
phi_10320_ = type_23(_e4511, _e4505);
} else {
phi_10320_ = type_23(_e4505, _e4511);
}
let _e4525 = phi_10320_;
if _e4223 {
phi_10371_ = 0u;
} else {
if (_e856 == 1u) {
phi_10370_ = 0u;
} else {
if (_e856 == 2u) {
phi_10369_ = _e3544;
} else {
phi_10369_ = select(_e3550, _e3547, (_e856 == 3u));
}
let _e4533 = phi_10369_;
phi_10370_ = _e4533;
}
let _e4535 = phi_10370_;
phi_10371_ = _e4535;
}
let _e4537 = phi_10371_;
local_44 = (((bitcast<i32>(_e4537) + _e4525.member_1) * _e3541) + _e4525.member);
let _e4542 = local_44;
let _e4544 = select(_e3567, _e4542, (_e4542 < _e3567));
let _e4549 = global_5.member[bitcast<u32>(select(0i, _e4544, (_e4544 > 0i)))];
let _e4554 = (((((select(_e4515, _e4519, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e4559 = ((1f - (((select(_e4519, _e4515, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e4566 = ((_e3146.member * _e4554) + (_e3154.member * _e4559));
let _e4567 = ((_e3146.member_1 * _e4554) + (_e3154.member_1 * _e4559));
let _e4568 = ((_e3146.member_2 * _e4554) + (_e3154.member_2 * _e4559));
let _e4572 = select((_e3169.member + _e4566), _e3169.member, _e3167);
let _e4573 = select((_e3169.member_1 + _e4567), _e3169.member_1, _e3167);
let _e4574 = select((_e3169.member_2 + _e4568), _e3169.member_2, _e3167);
let _e4585 = (((_e4572 * _e4572) + (_e4573 * _e4573)) + (_e4574 * _e4574));
let _e4589 = (1f / sqrt(select(0f, _e4585, (_e4585 > 0f))));
let _e4590 = (_e4572 * _e4589);
let _e4591 = (_e4573 * _e4589);
let _e4592 = (_e4574 * _e4589);
let _e4593 = (_e444 - select(_e3180.member, (_e3180.member + _e4566), _e3167));
let _e4594 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e4567), _e3167));
let _e4595 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e4568), _e3167));
let _e4600 = (((_e4593 * _e4590) + (_e4594 * _e4591)) + (_e4595 * _e4592));
let _e4605 = (((_e4593 * _e482) + (_e4594 * _e495)) + (_e4595 * _e508));
let _e4610 = (((_e4590 * _e482) + (_e4591 * _e495)) + (_e4592 * _e508));
let _e4613 = ((_e4591 * _e508) - (_e4592 * _e495));
let _e4616 = ((_e4592 * _e482) - (_e4590 * _e508));
let _e4619 = ((_e4590 * _e495) - (_e4591 * _e482));
let _e4624 = (((_e4613 * _e4613) + (_e4616 * _e4616)) + (_e4619 * _e4619));
let _e4627 = (1f / select(1e-9f, _e4624, (_e4624 > 1e-9f)));
let _e4630 = ((_e4600 - (_e4610 * _e4605)) * _e4627);
let _e4633 = (((_e4610 * _e4600) - _e4605) * _e4627);
let _e4639 = select(0f, _e4630, (((_e4633 >= 0f) && (_e4633 < _e560)) && (_e4630 > 0f)));
let _e4641 = (_e4505 << bitcast<u32>(_e4131));
if _e4353 {
phi_10788_ = (_e4147.member - 1i);
} else {
phi_10788_ = _e4352;
}
let _e4656 = phi_10788_;
if _e4508 {
phi_10799_ = (_e4147.member_1 - 1i);
} else {
phi_10799_ = _e4507;
}
let _e4659 = phi_10799_;
let _e4663 = (((f32(_e4656) + 0.5f) * _e4152) - 0.5f);
let _e4667 = (((f32(_e4659) + 0.5f) * _e4152) - 0.5f);
if _e326 {
phi_10827_ = type_23(_e4659, _e4656);
} else {
phi_10827_ = type_23(_e4656, _e4659);
}
let _e4673 = phi_10827_;
if _e4223 {
phi_10878_ = 0u;
} else {
if (_e856 == 1u) {
phi_10877_ = 0u;
} else {
if (_e856 == 2u) {
phi_10876_ = _e3544;
} else {
phi_10876_ = select(_e3550, _e3547, (_e856 == 3u));
}
let _e4681 = phi_10876_;
phi_10877_ = _e4681;
}
let _e4683 = phi_10877_;
phi_10878_ = _e4683;
}
let _e4685 = phi_10878_;
local_42 = (((bitcast<i32>(_e4685) + _e4673.member_1) * _e3541) + _e4673.member);
let _e4690 = local_42;
let _e4692 = select(_e3567, _e4690, (_e4690 < _e3567));
let _e4697 = global_5.member[bitcast<u32>(select(0i, _e4692, (_e4692 > 0i)))];
let _e4702 = (((((select(_e4663, _e4667, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e4707 = ((1f - (((select(_e4667, _e4663, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e4714 = ((_e3146.member * _e4702) + (_e3154.member * _e4707));
let _e4715 = ((_e3146.member_1 * _e4702) + (_e3154.member_1 * _e4707));
let _e4716 = ((_e3146.member_2 * _e4702) + (_e3154.member_2 * _e4707));
let _e4720 = select((_e3169.member + _e4714), _e3169.member, _e3167);
let _e4721 = select((_e3169.member_1 + _e4715), _e3169.member_1, _e3167);
let _e4722 = select((_e3169.member_2 + _e4716), _e3169.member_2, _e3167);
let _e4733 = (((_e4720 * _e4720) + (_e4721 * _e4721)) + (_e4722 * _e4722));
let _e4737 = (1f / sqrt(select(0f, _e4733, (_e4733 > 0f))));
let _e4738 = (_e4720 * _e4737);
let _e4739 = (_e4721 * _e4737);
let _e4740 = (_e4722 * _e4737);
let _e4741 = (_e444 - select(_e3180.member, (_e3180.member + _e4714), _e3167));
let _e4742 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e4715), _e3167));
let _e4743 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e4716), _e3167));
let _e4748 = (((_e4741 * _e4738) + (_e4742 * _e4739)) + (_e4743 * _e4740));
let _e4753 = (((_e4741 * _e482) + (_e4742 * _e495)) + (_e4743 * _e508));
let _e4758 = (((_e4738 * _e482) + (_e4739 * _e495)) + (_e4740 * _e508));
let _e4761 = ((_e4739 * _e508) - (_e4740 * _e495));
let _e4764 = ((_e4740 * _e482) - (_e4738 * _e508));
let _e4767 = ((_e4738 * _e495) - (_e4739 * _e482));
let _e4772 = (((_e4761 * _e4761) + (_e4764 * _e4764)) + (_e4767 * _e4767));
let _e4775 = (1f / select(1e-9f, _e4772, (_e4772 > 1e-9f)));
let _e4778 = ((_e4748 - (_e4758 * _e4753)) * _e4775);
let _e4781 = (((_e4758 * _e4748) - _e4753) * _e4775);
let _e4787 = select(0f, _e4778, (((_e4781 >= 0f) && (_e4781 < _e560)) && (_e4778 > 0f)));
let _e4789 = (_e4656 << bitcast<u32>(_e4131));
let _e4801 = select(((((_e4130 - select(0f, (_e4192 * _e4193), (((select(select(_e635, _e796, (_e4337 >= _e561)), _e716, (_e4337 < _e171)) == _e856) && (_e4335 > 0f)) && (_e4335 < _e4245)))) - select(0f, (_e4189 * _e4193), (((select(select(_e635, _e796, (_e4489 >= _e561)), _e716, (_e4489 < _e171)) == _e856) && (_e4487 > 0f)) && (_e4487 < _e4397)))) - select(0f, (_e4192 * _e4191), (((select(select(_e635, _e796, (_e4641 >= _e561)), _e716, (_e4641 < _e171)) == _e856) && (_e4639 > 0f)) && (_e4639 < _e4549)))) - select(0f, (_e4189 * _e4191), (((select(select(_e635, _e796, (_e4789 >= _e561)), _e716, (_e4789 < _e171)) == _e856) && (_e4787 > 0f)) && (_e4787 < _e4697)))), _e4130, _e4223);
let _e4802 = (_e860 & 31u);
let _e4804 = (1u << bitcast<u32>(_e4802));
let _e4813 = bitcast<i32>((((_e799 + _e4804) - 1u) >> bitcast<u32>(_e4802)));
let _e4814 = bitcast<i32>((((_e802 + _e4804) - 1u) >> bitcast<u32>(_e4802)));
if _e326 {
phi_11313_ = type_23(_e4814, _e4813);
} else {
phi_11313_ = type_23(_e4813, _e4814);
}
let _e4818 = phi_11313_;
let _e4823 = f32((1i << bitcast<u32>(_e4802)));
let _e4824 = (1f / _e4823);
let _e4826 = ((_e2957 * _e4824) - 0.5f);
let _e4828 = ((_e3050 * _e4824) - 0.5f);
let _e4830 = select(-1f, _e4826, (_e4826 > -1f));
let _e4832 = select(1e6f, _e4830, (_e4830 < 1e6f));
let _e4839 = select(0i, select(select(i32(_e4832), i32(-2147483648), (_e4832 < -2147483600f)), 2147483647i, (_e4832 > 2147483500f)), (_e4832 == _e4832));
let _e4843 = (_e4839 - select(0i, 1i, (_e4832 < f32(_e4839))));
let _e4845 = select(-1f, _e4828, (_e4828 > -1f));
let _e4847 = select(1e6f, _e4845, (_e4845 < 1e6f));
let _e4854 = select(0i, select(select(i32(_e4847), i32(-2147483648), (_e4847 < -2147483600f)), 2147483647i, (_e4847 > 2147483500f)), (_e4847 == _e4847));
let _e4858 = (_e4854 - select(0i, 1i, (_e4847 < f32(_e4854))));
let _e4860 = (_e4826 - f32(_e4843));
let _e4862 = (_e4828 - f32(_e4858));
let _e4863 = (1f - _e4860);
let _e4864 = (1f - _e4862);
let _e4867 = select(_e4843, 0i, (_e4843 < 0i));
let _e4868 = (_e4867 >= _e4818.member);
if _e4868 {
phi_11391_ = (_e4818.member - 1i);
} else {
phi_11391_ = _e4867;
}
let _e4871 = phi_11391_;
let _e4873 = select(_e4858, 0i, (_e4858 < 0i));
let _e4874 = (_e4873 >= _e4818.member_1);
if _e4874 {
phi_11402_ = (_e4818.member_1 - 1i);
} else {
phi_11402_ = _e4873;
}
let _e4877 = phi_11402_;
let _e4881 = (((f32(_e4871) + 0.5f) * _e4823) - 0.5f);
let _e4885 = (((f32(_e4877) + 0.5f) * _e4823) - 0.5f);
if _e326 {
phi_11430_ = type_23(_e4877, _e4871);
} else {
phi_11430_ = type_23(_e4871, _e4877);
}
let _e4891 = phi_11430_;
let _e4894 = (_e860 == 0u);
if _e4894 {
phi_11481_ = 0u;
} else {
if (_e860 == 1u) {
phi_11480_ = 0u;
} else {
if (_e860 == 2u) {
phi_11479_ = _e3544;
} else {
phi_11479_ = select(_e3550, _e3547, (_e860 == 3u));
}
let _e4900 = phi_11479_;
phi_11480_ = _e4900;
}
let _e4902 = phi_11480_;
phi_11481_ = _e4902;
}
let _e4904 = phi_11481_;
local_40 = (((bitcast<i32>(_e4904) + _e4891.member_1) * _e3541) + _e4891.member);
let _e4909 = local_40;
let _e4911 = select(_e3567, _e4909, (_e4909 < _e3567));
let _e4916 = global_5.member[bitcast<u32>(select(0i, _e4911, (_e4911 > 0i)))];
let _e4921 = (((((select(_e4881, _e4885, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e4926 = ((1f - (((select(_e4885, _e4881, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e4933 = ((_e3146.member * _e4921) + (_e3154.member * _e4926));
let _e4934 = ((_e3146.member_1 * _e4921) + (_e3154.member_1 * _e4926));
let _e4935 = ((_e3146.member_2 * _e4921) + (_e3154.member_2 * _e4926));
let _e4939 = select((_e3169.member + _e4933), _e3169.member, _e3167);
let _e4940 = select((_e3169.member_1 + _e4934), _e3169.member_1, _e3167);
let _e4941 = select((_e3169.member_2 + _e4935), _e3169.member_2, _e3167);
let _e4952 = (((_e4939 * _e4939) + (_e4940 * _e4940)) + (_e4941 * _e4941));
let _e4956 = (1f / sqrt(select(0f, _e4952, (_e4952 > 0f))));
let _e4957 = (_e4939 * _e4956);
let _e4958 = (_e4940 * _e4956);
let _e4959 = (_e4941 * _e4956);
let _e4960 = (_e444 - select(_e3180.member, (_e3180.member + _e4933), _e3167));
let _e4961 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e4934), _e3167));
let _e4962 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e4935), _e3167));
let _e4967 = (((_e4960 * _e4957) + (_e4961 * _e4958)) + (_e4962 * _e4959));
let _e4972 = (((_e4960 * _e482) + (_e4961 * _e495)) + (_e4962 * _e508));
let _e4977 = (((_e4957 * _e482) + (_e4958 * _e495)) + (_e4959 * _e508));
let _e4980 = ((_e4958 * _e508) - (_e4959 * _e495));
let _e4983 = ((_e4959 * _e482) - (_e4957 * _e508));
let _e4986 = ((_e4957 * _e495) - (_e4958 * _e482));
let _e4991 = (((_e4980 * _e4980) + (_e4983 * _e4983)) + (_e4986 * _e4986));
let _e4994 = (1f / select(1e-9f, _e4991, (_e4991 > 1e-9f)));
let _e4997 = ((_e4967 - (_e4977 * _e4972)) * _e4994);
let _e5000 = (((_e4977 * _e4967) - _e4972) * _e4994);
let _e5006 = select(0f, _e4997, (((_e5000 >= 0f) && (_e5000 < _e560)) && (_e4997 > 0f)));
let _e5008 = (_e4871 << bitcast<u32>(_e4802));
let _e5020 = (_e4843 + 1i);
let _e5023 = select(_e5020, 0i, (_e5020 < 0i));
let _e5024 = (_e5023 >= _e4818.member);
if _e5024 {
phi_11898_ = (_e4818.member - 1i);
} else {
phi_11898_ = _e5023;
}
let _e5027 = phi_11898_;
if _e4874 {
phi_11909_ = (_e4818.member_1 - 1i);
} else {
phi_11909_ = _e4873;
}
let _e5030 = phi_11909_;
let _e5034 = (((f32(_e5027) + 0.5f) * _e4823) - 0.5f);
let _e5038 = (((f32(_e5030) + 0.5f) * _e4823) - 0.5f);
if _e326 {
phi_11937_ = type_23(_e5030, _e5027);
} else {
phi_11937_ = type_23(_e5027, _e5030);
}
let _e5044 = phi_11937_;
if _e4894 {
phi_11988_ = 0u;
} else {
if (_e860 == 1u) {
phi_11987_ = 0u;
} else {
if (_e860 == 2u) {
phi_11986_ = _e3544;
} else {
phi_11986_ = select(_e3550, _e3547, (_e860 == 3u));
}
let _e5052 = phi_11986_;
phi_11987_ = _e5052;
}
let _e5054 = phi_11987_;
phi_11988_ = _e5054;
}
let _e5056 = phi_11988_;
local_38 = (((bitcast<i32>(_e5056) + _e5044.member_1) * _e3541) + _e5044.member);
let _e5061 = local_38;
let _e5063 = select(_e3567, _e5061, (_e5061 < _e3567));
let _e5068 = global_5.member[bitcast<u32>(select(0i, _e5063, (_e5063 > 0i)))];
let _e5073 = (((((select(_e5034, _e5038, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e5078 = ((1f - (((select(_e5038, _e5034, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e5085 = ((_e3146.member * _e5073) + (_e3154.member * _e5078));
let _e5086 = ((_e3146.member_1 * _e5073) + (_e3154.member_1 * _e5078));
let _e5087 = ((_e3146.member_2 * _e5073) + (_e3154.member_2 * _e5078));
let _e5091 = select((_e3169.member + _e5085), _e3169.member, _e3167);
let _e5092 = select((_e3169.member_1 + _e5086), _e3169.member_1, _e3167);
let _e5093 = select((_e3169.member_2 + _e5087), _e3169.member_2, _e3167);
let _e5104 = (((_e5091 * _e5091) + (_e5092 * _e5092)) + (_e5093 * _e5093));
let _e5108 = (1f / sqrt(select(0f, _e5104, (_e5104 > 0f))));
let _e5109 = (_e5091 * _e5108);
let _e5110 = (_e5092 * _e5108);
let _e5111 = (_e5093 * _e5108);
let _e5112 = (_e444 - select(_e3180.member, (_e3180.member + _e5085), _e3167));
let _e5113 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e5086), _e3167));
let _e5114 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e5087), _e3167));
let _e5119 = (((_e5112 * _e5109) + (_e5113 * _e5110)) + (_e5114 * _e5111));
let _e5124 = (((_e5112 * _e482) + (_e5113 * _e495)) + (_e5114 * _e508));
let _e5129 = (((_e5109 * _e482) + (_e5110 * _e495)) + (_e5111 * _e508));
let _e5132 = ((_e5110 * _e508) - (_e5111 * _e495));
let _e5135 = ((_e5111 * _e482) - (_e5109 * _e508));
let _e5138 = ((_e5109 * _e495) - (_e5110 * _e482));
let _e5143 = (((_e5132 * _e5132) + (_e5135 * _e5135)) + (_e5138 * _e5138));
let _e5146 = (1f / select(1e-9f, _e5143, (_e5143 > 1e-9f)));
let _e5149 = ((_e5119 - (_e5129 * _e5124)) * _e5146);
let _e5152 = (((_e5129 * _e5119) - _e5124) * _e5146);
let _e5158 = select(0f, _e5149, (((_e5152 >= 0f) && (_e5152 < _e560)) && (_e5149 > 0f)));
let _e5160 = (_e5027 << bitcast<u32>(_e4802));
let _e5172 = (_e4858 + 1i);
if _e4868 {
phi_12405_ = (_e4818.member - 1i);
} else {
phi_12405_ = _e4867;
}
let _e5176 = phi_12405_;
let _e5178 = select(_e5172, 0i, (_e5172 < 0i));
let _e5179 = (_e5178 >= _e4818.member_1);
if _e5179 {
phi_12416_ = (_e4818.member_1 - 1i);
} else {
phi_12416_ = _e5178;
}
let _e5182 = phi_12416_;
let _e5186 = (((f32(_e5176) + 0.5f) * _e4823) - 0.5f);
let _e5190 = (((f32(_e5182) + 0.5f) * _e4823) - 0.5f);
if _e326 {
phi_12444_ = type_23(_e5182, _e5176);
} else {
phi_12444_ = type_23(_e5176, _e5182);
}
let _e5196 = phi_12444_;
if _e4894 {
phi_12495_ = 0u;
} else {
if (_e860 == 1u) {
phi_12494_ = 0u;
} else {
if (_e860 == 2u) {
phi_12493_ = _e3544;
} else {
phi_12493_ = select(_e3550, _e3547, (_e860 == 3u));
}
let _e5204 = phi_12493_;
phi_12494_ = _e5204;
}
let _e5206 = phi_12494_;
phi_12495_ = _e5206;
}
let _e5208 = phi_12495_;
local_36 = (((bitcast<i32>(_e5208) + _e5196.member_1) * _e3541) + _e5196.member);
let _e5213 = local_36;
let _e5215 = select(_e3567, _e5213, (_e5213 < _e3567));
let _e5220 = global_5.member[bitcast<u32>(select(0i, _e5215, (_e5215 > 0i)))];
let _e5225 = (((((select(_e5186, _e5190, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e5230 = ((1f - (((select(_e5190, _e5186, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e5237 = ((_e3146.member * _e5225) + (_e3154.member * _e5230));
let _e5238 = ((_e3146.member_1 * _e5225) + (_e3154.member_1 * _e5230));
let _e5239 = ((_e3146.member_2 * _e5225) + (_e3154.member_2 * _e5230));
let _e5243 = select((_e3169.member + _e5237), _e3169.member, _e3167);
let _e5244 = select((_e3169.member_1 + _e5238), _e3169.member_1, _e3167);
let _e5245 = select((_e3169.member_2 + _e5239), _e3169.member_2, _e3167);
let _e5256 = (((_e5243 * _e5243) + (_e5244 * _e5244)) + (_e5245 * _e5245));
let _e5260 = (1f / sqrt(select(0f, _e5256, (_e5256 > 0f))));
let _e5261 = (_e5243 * _e5260);
let _e5262 = (_e5244 * _e5260);
let _e5263 = (_e5245 * _e5260);
let _e5264 = (_e444 - select(_e3180.member, (_e3180.member + _e5237), _e3167));
let _e5265 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e5238), _e3167));
let _e5266 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e5239), _e3167));
let _e5271 = (((_e5264 * _e5261) + (_e5265 * _e5262)) + (_e5266 * _e5263));
let _e5276 = (((_e5264 * _e482) + (_e5265 * _e495)) + (_e5266 * _e508));
let _e5281 = (((_e5261 * _e482) + (_e5262 * _e495)) + (_e5263 * _e508));
let _e5284 = ((_e5262 * _e508) - (_e5263 * _e495));
let _e5287 = ((_e5263 * _e482) - (_e5261 * _e508));
let _e5290 = ((_e5261 * _e495) - (_e5262 * _e482));
let _e5295 = (((_e5284 * _e5284) + (_e5287 * _e5287)) + (_e5290 * _e5290));
let _e5298 = (1f / select(1e-9f, _e5295, (_e5295 > 1e-9f)));
let _e5301 = ((_e5271 - (_e5281 * _e5276)) * _e5298);
let _e5304 = (((_e5281 * _e5271) - _e5276) * _e5298);
let _e5310 = select(0f, _e5301, (((_e5304 >= 0f) && (_e5304 < _e560)) && (_e5301 > 0f)));
let _e5312 = (_e5176 << bitcast<u32>(_e4802));
if _e5024 {
phi_12912_ = (_e4818.member - 1i);
} else {
phi_12912_ = _e5023;
}
let _e5327 = phi_12912_;
if _e5179 {
phi_12923_ = (_e4818.member_1 - 1i);
} else {
phi_12923_ = _e5178;
}
let _e5330 = phi_12923_;
let _e5334 = (((f32(_e5327) + 0.5f) * _e4823) - 0.5f);
let _e5338 = (((f32(_e5330) + 0.5f) * _e4823) - 0.5f);
if _e326 {
phi_12951_ = type_23(_e5330, _e5327);
} else {
phi_12951_ = type_23(_e5327, _e5330);
}
let _e5344 = phi_12951_;
if _e4894 {
phi_13002_ = 0u;
} else {
if (_e860 == 1u) {
phi_13001_ = 0u;
} else {
if (_e860 == 2u) {
phi_13000_ = _e3544;
} else {
phi_13000_ = select(_e3550, _e3547, (_e860 == 3u));
}
let _e5352 = phi_13000_;
phi_13001_ = _e5352;
}
let _e5354 = phi_13001_;
phi_13002_ = _e5354;
}
let _e5356 = phi_13002_;
local_34 = (((bitcast<i32>(_e5356) + _e5344.member_1) * _e3541) + _e5344.member);
let _e5361 = local_34;
let _e5363 = select(_e3567, _e5361, (_e5361 < _e3567));
let _e5368 = global_5.member[bitcast<u32>(select(0i, _e5363, (_e5363 > 0i)))];
let _e5373 = (((((select(_e5334, _e5338, _e326) + 0.5f) / _e3127) * 2f) - 1f) * _e3135);
let _e5378 = ((1f - (((select(_e5338, _e5334, _e326) + 0.5f) / _e3128) * 2f)) * _e3143);
let _e5385 = ((_e3146.member * _e5373) + (_e3154.member * _e5378));
let _e5386 = ((_e3146.member_1 * _e5373) + (_e3154.member_1 * _e5378));
let _e5387 = ((_e3146.member_2 * _e5373) + (_e3154.member_2 * _e5378));
let _e5391 = select((_e3169.member + _e5385), _e3169.member, _e3167);
let _e5392 = select((_e3169.member_1 + _e5386), _e3169.member_1, _e3167);
let _e5393 = select((_e3169.member_2 + _e5387), _e3169.member_2, _e3167);
let _e5404 = (((_e5391 * _e5391) + (_e5392 * _e5392)) + (_e5393 * _e5393));
let _e5408 = (1f / sqrt(select(0f, _e5404, (_e5404 > 0f))));
let _e5409 = (_e5391 * _e5408);
let _e5410 = (_e5392 * _e5408);
let _e5411 = (_e5393 * _e5408);
let _e5412 = (_e444 - select(_e3180.member, (_e3180.member + _e5385), _e3167));
let _e5413 = (_e456 - select(_e3180.member_1, (_e3180.member_1 + _e5386), _e3167));
let _e5414 = (_e469 - select(_e3180.member_2, (_e3180.member_2 + _e5387), _e3167));
let _e5419 = (((_e5412 * _e5409) + (_e5413 * _e5410)) + (_e5414 * _e5411));
let _e5424 = (((_e5412 * _e482) + (_e5413 * _e495)) + (_e5414 * _e508));
let _e5429 = (((_e5409 * _e482) + (_e5410 * _e495)) + (_e5411 * _e508));
let _e5432 = ((_e5410 * _e508) - (_e5411 * _e495));
let _e5435 = ((_e5411 * _e482) - (_e5409 * _e508));
let _e5438 = ((_e5409 * _e495) - (_e5410 * _e482));
let _e5443 = (((_e5432 * _e5432) + (_e5435 * _e5435)) + (_e5438 * _e5438));
let _e5446 = (1f / select(1e-9f, _e5443, (_e5443 > 1e-9f)));
let _e5449 = ((_e5419 - (_e5429 * _e5424)) * _e5446);
let _e5452 = (((_e5429 * _e5419) - _e5424) * _e5446);
let _e5458 = select(0f, _e5449, (((_e5452 >= 0f) && (_e5452 < _e560)) && (_e5449 > 0f)));
let _e5460 = (_e5327 << bitcast<u32>(_e4802));
let _e5472 = select(((((_e4801 - select(0f, (_e4863 * _e4864), (((select(select(_e635, _e796, (_e5008 >= _e561)), _e716, (_e5008 < _e171)) == _e860) && (_e5006 > 0f)) && (_e5006 < _e4916)))) - select(0f, (_e4860 * _e4864), (((select(select(_e635, _e796, (_e5160 >= _e561)), _e716, (_e5160 < _e171)) == _e860) && (_e5158 > 0f)) && (_e5158 < _e5068)))) - select(0f, (_e4863 * _e4862), (((select(select(_e635, _e796, (_e5312 >= _e561)), _e716, (_e5312 < _e171)) == _e860) && (_e5310 > 0f)) && (_e5310 < _e5220)))) - select(0f, (_e4860 * _e4862), (((select(select(_e635, _e796, (_e5460 >= _e561)), _e716, (_e5460 < _e171)) == _e860) && (_e5458 > 0f)) && (_e5458 < _e5368)))), _e4801, _e4894);
if _e326 {
phi_13428_ = type_23(_e3047, _e2955);
} else {
phi_13428_ = type_23(_e2955, _e3047);
}
let _e5487 = phi_13428_;
let _e5490 = (_e3048 && (((_e3445 > 0f) && (_e3445 < _e3116)) && (bitcast<f32>((bitcast<u32>(_e5472) & 2147483647u)) > 1e-6f)));
let _e5493 = global_1.member.member_18.member;
let _e5494 = (((select(_e3073, (1f - _e3073), (_e3058 >= 0f)) - select(_e3092, (1f - _e3092), (_e3077 >= 0f))) * (1f / _e3055)) * _e5493);
let _e5498 = select(0f, (((((_e521 * _e3432.member) * ((1f + (_e3285 * (1f + (_e3285 * (0.5f + (_e3285 * (0.16666667f + (_e3285 * (0.041666668f + (_e3285 * (0.008333334f + (_e3285 * (0.001388889f + (_e3285 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3280 + 127i)) << bitcast<u32>(23i))))) * _e3429) * _e5472) * _e5494), _e5490);
let _e5499 = select(0f, (((((_e534 * _e3432.member_1) * ((1f + (_e3333 * (1f + (_e3333 * (0.5f + (_e3333 * (0.16666667f + (_e3333 * (0.041666668f + (_e3333 * (0.008333334f + (_e3333 * (0.001388889f + (_e3333 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3328 + 127i)) << bitcast<u32>(23i))))) * _e3429) * _e5472) * _e5494), _e5490);
let _e5500 = select(0f, (((((_e547 * _e3432.member_2) * ((1f + (_e3381 * (1f + (_e3381 * (0.5f + (_e3381 * (0.16666667f + (_e3381 * (0.041666668f + (_e3381 * (0.008333334f + (_e3381 * (0.001388889f + (_e3381 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3376 + 127i)) << bitcast<u32>(23i))))) * _e3429) * _e5472) * _e5494), _e5490);
let _e5504 = (bitcast<f32>((bitcast<u32>(_e5498) & 2147483647u)) >= 1073741800f);
let _e5505 = (1f / 1048576f);
let _e5508 = ((_e5498 * select(1f, _e5505, _e5504)) + 0.5f);
let _e5510 = select(-1073741800f, _e5508, (_e5508 > -1073741800f));
let _e5512 = select(1073741800f, _e5510, (_e5510 < 1073741800f));
let _e5519 = select(0i, select(select(i32(_e5512), i32(-2147483648), (_e5512 < -2147483600f)), 2147483647i, (_e5512 > 2147483500f)), (_e5512 == _e5512));
let _e5523 = (_e5519 - select(0i, 1i, (_e5512 < f32(_e5519))));
let _e5524 = select(0i, 20i, _e5504);
let _e5528 = (bitcast<u32>(_e5523) << bitcast<u32>((_e5524 & 31i)));
let _e5535 = bitcast<u32>(((_e5523 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e5524) & 31i))));
let _e5539 = (bitcast<f32>((bitcast<u32>(_e5499) & 2147483647u)) >= 1073741800f);
let _e5542 = ((_e5499 * select(1f, _e5505, _e5539)) + 0.5f);
let _e5544 = select(-1073741800f, _e5542, (_e5542 > -1073741800f));
let _e5546 = select(1073741800f, _e5544, (_e5544 < 1073741800f));
let _e5553 = select(0i, select(select(i32(_e5546), i32(-2147483648), (_e5546 < -2147483600f)), 2147483647i, (_e5546 > 2147483500f)), (_e5546 == _e5546));
let _e5557 = (_e5553 - select(0i, 1i, (_e5546 < f32(_e5553))));
let _e5558 = select(0i, 20i, _e5539);
let _e5562 = (bitcast<u32>(_e5557) << bitcast<u32>((_e5558 & 31i)));
let _e5569 = bitcast<u32>(((_e5557 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e5558) & 31i))));
let _e5573 = (bitcast<f32>((bitcast<u32>(_e5500) & 2147483647u)) >= 1073741800f);
let _e5576 = ((_e5500 * select(1f, _e5505, _e5573)) + 0.5f);
let _e5578 = select(-1073741800f, _e5576, (_e5576 > -1073741800f));
let _e5580 = select(1073741800f, _e5578, (_e5578 < 1073741800f));
let _e5587 = select(0i, select(select(i32(_e5580), i32(-2147483648), (_e5580 < -2147483600f)), 2147483647i, (_e5580 > 2147483500f)), (_e5580 == _e5580));
let _e5591 = (_e5587 - select(0i, 1i, (_e5580 < f32(_e5587))));
let _e5592 = select(0i, 20i, _e5573);
let _e5596 = (bitcast<u32>(_e5591) << bitcast<u32>((_e5592 & 31i)));
let _e5603 = bitcast<u32>(((_e5591 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e5592) & 31i))));
let _e5608 = bitcast<i32>(bitcast<u32>((((_e5487.member_1 * _e803) + _e5487.member) * 6i)));
if ((_e5528 | _e5535) == 0u) {
} else {
let _e5611 = bitcast<u32>(_e5608);
if (_e5611 < _e143) {
let _e5615 = atomicAdd((&global_6.member[_e5611]), _e5528);
phi_13661_ = _e5615;
} else {
phi_13661_ = 0u;
}
let _e5617 = phi_13661_;
let _e5621 = (_e5535 + select(0u, 1u, ((_e5617 + _e5528) < _e5528)));
if (_e5621 == 0u) {
} else {
let _e5623 = (_e5611 + 1u);
if (_e5623 < _e143) {
let _e5627 = atomicAdd((&global_6.member[_e5623]), _e5621);
}
}
}
if ((_e5562 | _e5569) == 0u) {
} else {
let _e5631 = bitcast<u32>((_e5608 + 2i));
if (_e5631 < _e143) {
let _e5635 = atomicAdd((&global_6.member[_e5631]), _e5562);
phi_13691_ = _e5635;
} else {
phi_13691_ = 0u;
}
let _e5637 = phi_13691_;
let _e5641 = (_e5569 + select(0u, 1u, ((_e5637 + _e5562) < _e5562)));
if (_e5641 == 0u) {
} else {
let _e5643 = (_e5631 + 1u);
if (_e5643 < _e143) {
let _e5647 = atomicAdd((&global_6.member[_e5643]), _e5641);
}
}
}
if ((_e5596 | _e5603) == 0u) {
} else {
let _e5651 = bitcast<u32>((_e5608 + 4i));
if (_e5651 < _e143) {
let _e5655 = atomicAdd((&global_6.member[_e5651]), _e5596);
phi_13721_ = _e5655;
} else {
phi_13721_ = 0u;
}
let _e5657 = phi_13721_;
let _e5661 = (_e5603 + select(0u, 1u, ((_e5657 + _e5596) < _e5596)));
if (_e5661 == 0u) {
} else {
let _e5663 = (_e5651 + 1u);
if (_e5663 < _e143) {
let _e5667 = atomicAdd((&global_6.member[_e5663]), _e5661);
}
}
}
phi_6417_ = (_e3045 + 1i);
} else {
phi_6417_ = i32();
}
let _e5670 = phi_6417_;
continue;
continuing {
phi_6416_ = _e5670;
break if !(_e3048);
}
}
phi_6263_ = (_e2952 + 1i);
} else {
phi_6263_ = i32();
}
let _e5674 = phi_6263_;
continue;
continuing {
phi_6262_ = _e5674;
break if !(_e2953);
}
}
}
}
} else {
let _e5676 = (_e635 & 31u);
let _e5678 = (1u << bitcast<u32>(_e5676));
let _e5687 = bitcast<i32>((((_e799 + _e5678) - 1u) >> bitcast<u32>(_e5676)));
let _e5688 = bitcast<i32>((((_e802 + _e5678) - 1u) >> bitcast<u32>(_e5676)));
if _e326 {
phi_13787_ = type_23(_e5688, _e5687);
} else {
phi_13787_ = type_23(_e5687, _e5688);
}
let _e5692 = phi_13787_;
let _e5696 = (_e829 >> bitcast<u32>(_e5676));
if (_e5696 < _e5692.member) {
phi_13862_ = _e5696;
} else {
phi_13862_ = (_e5692.member - 1i);
}
let _e5702 = phi_13862_;
phi_13866_ = type_23(2147483647i, -1i);
phi_13869_ = 0i;
loop {
let _e5705 = phi_13866_;
let _e5707 = phi_13869_;
local_81 = _e5705;
local_82 = _e5705;
let _e5708 = (_e5707 < 16i);
if _e5708 {
let _e5710 = (1i << bitcast<u32>(_e5676));
let _e5711 = f32(_e5710);
let _e5713 = ((4u - _e635) & 31u);
let _e5718 = ((_e847 >> bitcast<u32>(_e5676)) + (_e5707 & ((1i << bitcast<u32>(_e5713)) - 1i)));
let _e5722 = (((f32(_e5718) + 0.5f) * _e5711) - 0.5f);
let _e5726 = (-(((_e289 * _e5722) + _e315)) / _e302);
let _e5733 = bitcast<f32>((bitcast<u32>(((_e339 * _e5722) + ((_e352 * _e5726) + _e365))) & 2147483647u));
let _e5740 = bitcast<f32>((bitcast<u32>(((_e378 * _e5722) + ((_e391 * _e5726) + _e404))) & 2147483647u));
let _e5745 = (((0.5f * (_e5733 + _e5740)) / _e407) + (0.5f * _e5711));
let _e5746 = (1f / _e5711);
let _e5754 = ((((_e5726 + _e5745) + 0.5f) * _e5746) - 0.5f);
let _e5755 = f32((_e5692.member_1 - 1i));
let _e5756 = (0f - 1f);
let _e5758 = select(_e5756, _e5754, (_e5754 > _e5756));
let _e5760 = select(_e5755, _e5758, (_e5758 < _e5755));
let _e5767 = select(0i, select(select(i32(_e5760), i32(-2147483648), (_e5760 < -2147483600f)), 2147483647i, (_e5760 > 2147483500f)), (_e5760 == _e5760));
let _e5772 = (((((_e5726 - _e5745) + 0.5f) * _e5746) - 0.5f) + 1f);
let _e5773 = (_e5755 + 1f);
let _e5775 = select(0f, _e5772, (_e5772 > 0f));
let _e5777 = select(_e5773, _e5775, (_e5775 < _e5773));
let _e5784 = select(0i, select(select(i32(_e5777), i32(-2147483648), (_e5777 < -2147483600f)), 2147483647i, (_e5777 > 2147483500f)), (_e5777 == _e5777));
let _e5795 = ((1e-4f * _e5711) * _e407);
let _e5797 = select(_e5740, _e5733, (_e5733 > _e5740));
let _e5799 = select(_e5795, _e5797, (_e5797 > _e5795));
let _e5801 = select(_e5740, _e5733, (_e5733 < _e5740));
let _e5803 = select(_e5795, _e5801, (_e5801 > _e5795));
let _e5805 = (0.5f * (_e5799 + _e5803));
let _e5806 = (0.5f / _e5803);
let _e5807 = (1f / _e5799);
phi_14020_ = _e5705;
phi_14023_ = 0i;
loop {
let _e5809 = phi_14020_;
let _e5811 = phi_14023_;
local_89 = _e5809;
let _e5814 = (((_e5784 - select(0i, 1i, (_e5777 < f32(_e5784)))) + (_e5707 >> bitcast<u32>(_e5713))) + (_e5811 << bitcast<u32>(_e5676)));
let _e5815 = (_e5814 <= select(-1i, (_e5767 - select(0i, 1i, (_e5760 < f32(_e5767)))), (_e5718 <= _e5702)));
if _e5815 {
let _e5819 = (((f32(_e5814) + 0.5f) * _e5711) - 0.5f);
let _e5821 = ((_e5819 - _e5726) * _e407);
let _e5822 = (_e407 * _e5711);
let _e5824 = (0.5f * _e5822);
let _e5825 = (_e5821 + _e5824);
let _e5826 = -(_e5825);
let _e5829 = (_e5805 - select(_e5826, _e5825, (_e5825 > _e5826)));
let _e5831 = select(0f, _e5829, (_e5829 > 0f));
let _e5833 = select(_e5803, _e5831, (_e5831 < _e5803));
let _e5836 = (_e5829 - _e5803);
let _e5840 = (((_e5833 * (_e5833 * _e5806)) + select(0f, _e5836, (_e5836 > 0f))) * _e5807);
let _e5844 = (_e5821 - _e5824);
let _e5845 = -(_e5844);
let _e5848 = (_e5805 - select(_e5845, _e5844, (_e5844 > _e5845)));
let _e5850 = select(0f, _e5848, (_e5848 > 0f));
let _e5852 = select(_e5803, _e5850, (_e5850 < _e5803));
let _e5855 = (_e5848 - _e5803);
let _e5859 = (((_e5852 * (_e5852 * _e5806)) + select(0f, _e5855, (_e5855 > 0f))) * _e5807);
if _e326 {
phi_14153_ = type_23(_e5814, _e5718);
} else {
phi_14153_ = type_23(_e5718, _e5814);
}
let _e5870 = phi_14153_;
let _e5876 = bitcast<i32>(((_e799 + 1u) >> bitcast<u32>(1u)));
let _e5879 = global_1.member.member_18.member_9;
let _e5884 = global_1.member.member_18.member_6;
let _e5887 = global_1.member.member_18.member_7;
let _e5890 = global_1.member.member_18.member_8;
if _e854 {
phi_14204_ = 0u;
} else {
if (_e635 == 1u) {
phi_14203_ = 0u;
} else {
if (_e635 == 2u) {
phi_14202_ = _e5884;
} else {
phi_14202_ = select(_e5890, _e5887, (_e635 == 3u));
}
let _e5896 = phi_14202_;
phi_14203_ = _e5896;
}
let _e5898 = phi_14203_;
phi_14204_ = _e5898;
}
let _e5900 = phi_14204_;
local_32 = (((bitcast<i32>(_e5900) + _e5870.member_1) * _e5876) + _e5870.member);
local_33 = (_e5876 * bitcast<i32>(_e5879));
let _e5905 = local_32;
let _e5907 = (bitcast<i32>(_e141) - 1i);
let _e5909 = select(_e5907, _e5905, (_e5905 < _e5907));
let _e5914 = global_5.member[bitcast<u32>(select(0i, _e5909, (_e5909 > 0i)))];
let _e5915 = local_33;
let _e5916 = local_32;
let _e5917 = (_e5915 + _e5916);
let _e5919 = select(_e5907, _e5917, (_e5917 < _e5907));
let _e5924 = global_5.member[bitcast<u32>(select(0i, _e5919, (_e5919 > 0i)))];
let _e5925 = local_33;
let _e5927 = local_32;
let _e5928 = ((2i * _e5925) + _e5927);
let _e5930 = select(_e5907, _e5928, (_e5928 < _e5907));
let _e5935 = global_5.member[bitcast<u32>(select(0i, _e5930, (_e5930 > 0i)))];
let _e5936 = local_33;
let _e5938 = local_32;
let _e5939 = ((3i * _e5936) + _e5938);
let _e5941 = select(_e5907, _e5939, (_e5939 < _e5907));
let _e5946 = global_5.member[bitcast<u32>(select(0i, _e5941, (_e5941 > 0i)))];
let _e5955 = global_1.member.member_2.member;
let _e5956 = (((((select(_e5722, _e5819, _e326) + 0.5f) / f32(_e803)) * 2f) - 1f) * _e5955);
let _e5963 = global_1.member.member_2.member_1;
let _e5964 = ((1f - (((select(_e5819, _e5722, _e326) + 0.5f) / f32(_e804)) * 2f)) * _e5963);
let _e5966 = global_1.member.member_3;
let _e5974 = global_1.member.member_4;
let _e5981 = ((_e5966.member * _e5956) + (_e5974.member * _e5964));
let _e5982 = ((_e5966.member_1 * _e5956) + (_e5974.member_1 * _e5964));
let _e5983 = ((_e5966.member_2 * _e5956) + (_e5974.member_2 * _e5964));
let _e5986 = global_1.member.member_2.member_3;
let _e5987 = (_e5986 != 0u);
let _e5989 = global_1.member.member_5;
let _e5996 = select((_e5989.member + _e5981), _e5989.member, _e5987);
let _e5997 = select((_e5989.member_1 + _e5982), _e5989.member_1, _e5987);
let _e5998 = select((_e5989.member_2 + _e5983), _e5989.member_2, _e5987);
let _e6000 = global_1.member.member_6;
let _e6014 = (((_e5996 * _e5996) + (_e5997 * _e5997)) + (_e5998 * _e5998));
let _e6017 = sqrt(select(0f, _e6014, (_e6014 > 0f)));
let _e6018 = (1f / _e6017);
let _e6019 = (_e5996 * _e6018);
let _e6020 = (_e5997 * _e6018);
let _e6021 = (_e5998 * _e6018);
let _e6022 = (_e444 - select(_e6000.member, (_e6000.member + _e5981), _e5987));
let _e6023 = (_e456 - select(_e6000.member_1, (_e6000.member_1 + _e5982), _e5987));
let _e6024 = (_e469 - select(_e6000.member_2, (_e6000.member_2 + _e5983), _e5987));
let _e6029 = (((_e6022 * _e6019) + (_e6023 * _e6020)) + (_e6024 * _e6021));
let _e6034 = (((_e6022 * _e482) + (_e6023 * _e495)) + (_e6024 * _e508));
let _e6039 = (((_e6019 * _e482) + (_e6020 * _e495)) + (_e6021 * _e508));
let _e6042 = ((_e6020 * _e508) - (_e6021 * _e495));
let _e6045 = ((_e6021 * _e482) - (_e6019 * _e508));
let _e6048 = ((_e6019 * _e495) - (_e6020 * _e482));
let _e6053 = (((_e6042 * _e6042) + (_e6045 * _e6045)) + (_e6048 * _e6048));
let _e6056 = (1f / select(1e-9f, _e6053, (_e6053 > 1e-9f)));
let _e6059 = ((_e6029 - (_e6039 * _e6034)) * _e6056);
let _e6062 = (((_e6039 * _e6029) - _e6034) * _e6056);
let _e6068 = (_e6059 - _e5946);
let _e6071 = (_e6062 + select(0f, _e6068, (_e6068 > 0f)));
let _e6074 = global_1.member.member_13.member;
let _e6079 = -((_e6074.member * _e6071));
let _e6081 = select(-87f, _e6079, (_e6079 > -87f));
let _e6083 = select(88f, _e6081, (_e6081 < 88f));
let _e6085 = ((_e6083 * 1.442695f) + 0.5f);
let _e6087 = select(-127f, _e6085, (_e6085 > -127f));
let _e6089 = select(128f, _e6087, (_e6087 < 128f));
let _e6096 = select(0i, select(select(i32(_e6089), i32(-2147483648), (_e6089 < -2147483600f)), 2147483647i, (_e6089 > 2147483500f)), (_e6089 == _e6089));
let _e6100 = (_e6096 - select(0i, 1i, (_e6089 < f32(_e6096))));
let _e6101 = f32(_e6100);
let _e6105 = ((_e6083 - (_e6101 * 0.6933594f)) - (_e6101 * -2.1219444e-4f));
let _e6127 = -((_e6074.member_1 * _e6071));
let _e6129 = select(-87f, _e6127, (_e6127 > -87f));
let _e6131 = select(88f, _e6129, (_e6129 < 88f));
let _e6133 = ((_e6131 * 1.442695f) + 0.5f);
let _e6135 = select(-127f, _e6133, (_e6133 > -127f));
let _e6137 = select(128f, _e6135, (_e6135 < 128f));
let _e6144 = select(0i, select(select(i32(_e6137), i32(-2147483648), (_e6137 < -2147483600f)), 2147483647i, (_e6137 > 2147483500f)), (_e6137 == _e6137));
let _e6148 = (_e6144 - select(0i, 1i, (_e6137 < f32(_e6144))));
let _e6149 = f32(_e6148);
let _e6153 = ((_e6131 - (_e6149 * 0.6933594f)) - (_e6149 * -2.1219444e-4f));
let _e6175 = -((_e6074.member_2 * _e6071));
let _e6177 = select(-87f, _e6175, (_e6175 > -87f));
let _e6179 = select(88f, _e6177, (_e6177 < 88f));
let _e6181 = ((_e6179 * 1.442695f) + 0.5f);
let _e6183 = select(-127f, _e6181, (_e6181 > -127f));
let _e6185 = select(128f, _e6183, (_e6183 < 128f));
let _e6192 = select(0i, select(select(i32(_e6185), i32(-2147483648), (_e6185 < -2147483600f)), 2147483647i, (_e6185 > 2147483500f)), (_e6185 == _e6185));
let _e6196 = (_e6192 - select(0i, 1i, (_e6185 < f32(_e6192))));
let _e6197 = f32(_e6196);
let _e6201 = ((_e6179 - (_e6197 * 0.6933594f)) - (_e6197 * -2.1219444e-4f));
let _e6222 = -(_e6039);
let _e6225 = global_1.member.member_13.member_2;
let _e6226 = (_e6225 * _e6225);
let _e6230 = ((1f + _e6226) - ((2f * _e6225) * _e6222));
let _e6232 = select(1e-9f, _e6230, (_e6230 > 1e-9f));
let _e6244 = global_1.member.member_13.member_3;
let _e6249 = (_e6017 * (select(((1f - _e6226) / (_e6232 * sqrt(select(0f, _e6232, (_e6232 > 0f))))), (0.75f * (1f + (_e6222 * _e6222))), (_e6244 == 1u)) * (0.25f / 3.1415927f)));
let _e6252 = global_1.member.member_13.member_1;
let _e6265 = select(0f, _e6059, (((_e6062 >= 0f) && (_e6062 < _e560)) && (_e6059 > 0f)));
let _e6268 = ((_e6265 > 0f) && (_e6265 < _e5914));
if _e326 {
phi_14780_ = type_23(_e5814, _e5718);
} else {
phi_14780_ = type_23(_e5718, _e5814);
}
let _e6292 = phi_14780_;
let _e6295 = (_e5815 && _e6268);
let _e6298 = global_1.member.member_18.member;
let _e6299 = (((select(_e5840, (1f - _e5840), (_e5825 >= 0f)) - select(_e5859, (1f - _e5859), (_e5844 >= 0f))) * (1f / _e5822)) * _e6298);
let _e6303 = select(0f, ((((_e521 * _e6252.member) * ((1f + (_e6105 * (1f + (_e6105 * (0.5f + (_e6105 * (0.16666667f + (_e6105 * (0.041666668f + (_e6105 * (0.008333334f + (_e6105 * (0.001388889f + (_e6105 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6100 + 127i)) << bitcast<u32>(23i))))) * _e6249) * _e6299), _e6295);
let _e6304 = select(0f, ((((_e534 * _e6252.member_1) * ((1f + (_e6153 * (1f + (_e6153 * (0.5f + (_e6153 * (0.16666667f + (_e6153 * (0.041666668f + (_e6153 * (0.008333334f + (_e6153 * (0.001388889f + (_e6153 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6148 + 127i)) << bitcast<u32>(23i))))) * _e6249) * _e6299), _e6295);
let _e6305 = select(0f, ((((_e547 * _e6252.member_2) * ((1f + (_e6201 * (1f + (_e6201 * (0.5f + (_e6201 * (0.16666667f + (_e6201 * (0.041666668f + (_e6201 * (0.008333334f + (_e6201 * (0.001388889f + (_e6201 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6196 + 127i)) << bitcast<u32>(23i))))) * _e6249) * _e6299), _e6295);
let _e6309 = (bitcast<f32>((bitcast<u32>(_e6303) & 2147483647u)) >= 1073741800f);
let _e6310 = (1f / 1048576f);
let _e6313 = ((_e6303 * select(1f, _e6310, _e6309)) + 0.5f);
let _e6315 = select(-1073741800f, _e6313, (_e6313 > -1073741800f));
let _e6317 = select(1073741800f, _e6315, (_e6315 < 1073741800f));
let _e6324 = select(0i, select(select(i32(_e6317), i32(-2147483648), (_e6317 < -2147483600f)), 2147483647i, (_e6317 > 2147483500f)), (_e6317 == _e6317));
let _e6328 = (_e6324 - select(0i, 1i, (_e6317 < f32(_e6324))));
let _e6329 = select(0i, 20i, _e6309);
let _e6333 = (bitcast<u32>(_e6328) << bitcast<u32>((_e6329 & 31i)));
let _e6340 = bitcast<u32>(((_e6328 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6329) & 31i))));
let _e6344 = (bitcast<f32>((bitcast<u32>(_e6304) & 2147483647u)) >= 1073741800f);
let _e6347 = ((_e6304 * select(1f, _e6310, _e6344)) + 0.5f);
let _e6349 = select(-1073741800f, _e6347, (_e6347 > -1073741800f));
let _e6351 = select(1073741800f, _e6349, (_e6349 < 1073741800f));
let _e6358 = select(0i, select(select(i32(_e6351), i32(-2147483648), (_e6351 < -2147483600f)), 2147483647i, (_e6351 > 2147483500f)), (_e6351 == _e6351));
let _e6362 = (_e6358 - select(0i, 1i, (_e6351 < f32(_e6358))));
let _e6363 = select(0i, 20i, _e6344);
let _e6367 = (bitcast<u32>(_e6362) << bitcast<u32>((_e6363 & 31i)));
let _e6374 = bitcast<u32>(((_e6362 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6363) & 31i))));
let _e6378 = (bitcast<f32>((bitcast<u32>(_e6305) & 2147483647u)) >= 1073741800f);
let _e6381 = ((_e6305 * select(1f, _e6310, _e6378)) + 0.5f);
let _e6383 = select(-1073741800f, _e6381, (_e6381 > -1073741800f));
let _e6385 = select(1073741800f, _e6383, (_e6383 < 1073741800f));
let _e6392 = select(0i, select(select(i32(_e6385), i32(-2147483648), (_e6385 < -2147483600f)), 2147483647i, (_e6385 > 2147483500f)), (_e6385 == _e6385));
let _e6396 = (_e6392 - select(0i, 1i, (_e6385 < f32(_e6392))));
let _e6397 = select(0i, 20i, _e6378);
let _e6401 = (bitcast<u32>(_e6396) << bitcast<u32>((_e6397 & 31i)));
let _e6408 = bitcast<u32>(((_e6396 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6397) & 31i))));
let _e6413 = global_1.member.member_18.member_2;
let _e6416 = global_1.member.member_18.member_3;
let _e6419 = global_1.member.member_18.member_4;
let _e6422 = global_1.member.member_18.member_5;
if _e854 {
phi_14979_ = 0u;
} else {
if (_e635 == 1u) {
phi_14978_ = _e6413;
} else {
if (_e635 == 2u) {
phi_14977_ = _e6416;
} else {
phi_14977_ = select(_e6422, _e6419, (_e635 == 3u));
}
let _e6428 = phi_14977_;
phi_14978_ = _e6428;
}
let _e6430 = phi_14978_;
phi_14979_ = _e6430;
}
let _e6432 = phi_14979_;
let _e6440 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e6432) + (_e6292.member_1 * _e5687)) + _e6292.member) * 6i)));
if ((_e6333 | _e6340) == 0u) {
} else {
let _e6443 = bitcast<u32>(_e6440);
if (_e6443 < _e143) {
let _e6447 = atomicAdd((&global_6.member[_e6443]), _e6333);
phi_15013_ = _e6447;
} else {
phi_15013_ = 0u;
}
let _e6449 = phi_15013_;
let _e6453 = (_e6340 + select(0u, 1u, ((_e6449 + _e6333) < _e6333)));
if (_e6453 == 0u) {
} else {
let _e6455 = (_e6443 + 1u);
if (_e6455 < _e143) {
let _e6459 = atomicAdd((&global_6.member[_e6455]), _e6453);
}
}
}
if ((_e6367 | _e6374) == 0u) {
} else {
let _e6463 = bitcast<u32>((_e6440 + 2i));
if (_e6463 < _e143) {
let _e6467 = atomicAdd((&global_6.member[_e6463]), _e6367);
phi_15043_ = _e6467;
} else {
phi_15043_ = 0u;
}
let _e6469 = phi_15043_;
let _e6473 = (_e6374 + select(0u, 1u, ((_e6469 + _e6367) < _e6367)));
if (_e6473 == 0u) {
} else {
let _e6475 = (_e6463 + 1u);
if (_e6475 < _e143) {
let _e6479 = atomicAdd((&global_6.member[_e6475]), _e6473);
}
}
}
if ((_e6401 | _e6408) == 0u) {
} else {
let _e6483 = bitcast<u32>((_e6440 + 4i));
if (_e6483 < _e143) {
let _e6487 = atomicAdd((&global_6.member[_e6483]), _e6401);
phi_15073_ = _e6487;
} else {
phi_15073_ = 0u;
}
let _e6489 = phi_15073_;
let _e6493 = (_e6408 + select(0u, 1u, ((_e6489 + _e6401) < _e6401)));
if (_e6493 == 0u) {
} else {
let _e6495 = (_e6483 + 1u);
if (_e6495 < _e143) {
let _e6499 = atomicAdd((&global_6.member[_e6495]), _e6493);
}
}
}
let _e6500 = bitcast<i32>(bitcast<u32>(select(-1i, _e5814, (_e5815 && (!(((_e6268 && !(((((_e5718 * _e5710) == _e171) && (_e716 != _e635)) || ((((_e5718 + 1i) * _e5710) == _e561) && (_e796 != _e635))))) && ((_e6265 * (1f + (0.02f * _e5711))) < _e5935))) && (_e6265 <= _e5924))))));
if (_e6500 >= 0i) {
phi_15110_ = type_23(select(_e5809.member, _e6500, (_e6500 < _e5809.member)), select(_e5809.member_1, _e6500, (_e6500 > _e5809.member_1)));
} else {
phi_15110_ = _e5809;
}
let _e6510 = phi_15110_;
phi_14021_ = _e6510;
phi_14024_ = (_e5811 + 1i);
} else {
phi_14021_ = type_23();
phi_14024_ = i32();
}
let _e6513 = phi_14021_;
let _e6515 = phi_14024_;
continue;
continuing {
phi_14020_ = _e6513;
phi_14023_ = _e6515;
break if !(_e5815);
}
}
let _e11549 = local_89;
phi_13867_ = _e11549;
phi_13870_ = (_e5707 + 1i);
} else {
phi_13867_ = type_23();
phi_13870_ = i32();
}
let _e6519 = phi_13867_;
let _e6521 = phi_13870_;
continue;
continuing {
phi_13866_ = _e6519;
phi_13869_ = _e6521;
break if !(_e5708);
}
}
let _e6524 = local_81;
let _e6527 = local_82;
if (_e6524.member <= _e6527.member_1) {
let _e6532 = ((_e6527.member_1 + 1i) << bitcast<u32>(_e5676));
if (_e6532 <= _e853) {
phi_15127_ = (_e6532 - 1i);
} else {
phi_15127_ = _e853;
}
let _e6536 = phi_15127_;
let _e6538 = (_e6524.member << bitcast<u32>(_e5676));
let _e6540 = select(_e716, 0u, (_e716 == _e635));
let _e6544 = select(_e796, 0u, ((_e796 == _e635) || (_e796 == _e716)));
let _e6552 = ((select(0u, 1u, (_e635 > 0u)) + select(0u, 1u, (_e6540 > 0u))) + select(0u, 1u, (_e6544 > 0u)));
if (_e6552 == 0u) {
phi_15162_ = 0i;
loop {
let _e6555 = phi_15162_;
let _e6556 = (_e6555 < 16i);
if _e6556 {
let _e6558 = (_e848 + (_e6555 & 15i));
let _e6562 = (((f32(_e6558) + 0.5f) * 1f) - 0.5f);
let _e6566 = (-(((_e289 * _e6562) + _e315)) / _e302);
let _e6573 = bitcast<f32>((bitcast<u32>(((_e339 * _e6562) + ((_e352 * _e6566) + _e365))) & 2147483647u));
let _e6580 = bitcast<f32>((bitcast<u32>(((_e378 * _e6562) + ((_e391 * _e6566) + _e404))) & 2147483647u));
let _e6584 = (((0.5f * (_e6573 + _e6580)) / _e407) + _e586);
let _e6585 = (1f / 1f);
let _e6593 = ((((_e6566 + _e6584) + 0.5f) * _e6585) - 0.5f);
let _e6594 = f32(_e6538);
let _e6595 = f32(_e6536);
let _e6596 = (_e6594 - 1f);
let _e6598 = select(_e6596, _e6593, (_e6593 > _e6596));
let _e6600 = select(_e6595, _e6598, (_e6598 < _e6595));
let _e6607 = select(0i, select(select(i32(_e6600), i32(-2147483648), (_e6600 < -2147483600f)), 2147483647i, (_e6600 > 2147483500f)), (_e6600 == _e6600));
let _e6612 = (((((_e6566 - _e6584) + 0.5f) * _e6585) - 0.5f) + 1f);
let _e6613 = (_e6595 + 1f);
let _e6615 = select(_e6594, _e6612, (_e6612 > _e6594));
let _e6617 = select(_e6613, _e6615, (_e6615 < _e6613));
let _e6624 = select(0i, select(select(i32(_e6617), i32(-2147483648), (_e6617 < -2147483600f)), 2147483647i, (_e6617 > 2147483500f)), (_e6617 == _e6617));
let _e6635 = ((1e-4f * 1f) * _e407);
let _e6637 = select(_e6580, _e6573, (_e6573 > _e6580));
let _e6639 = select(_e6635, _e6637, (_e6637 > _e6635));
let _e6641 = select(_e6580, _e6573, (_e6573 < _e6580));
let _e6643 = select(_e6635, _e6641, (_e6641 > _e6635));
let _e6645 = (0.5f * (_e6639 + _e6643));
let _e6646 = (0.5f / _e6643);
let _e6647 = (1f / _e6639);
phi_15316_ = 0i;
loop {
let _e6649 = phi_15316_;
let _e6651 = (((_e6624 - select(0i, 1i, (_e6617 < f32(_e6624)))) + (_e6555 >> bitcast<u32>(4u))) + bitcast<i32>(_e6649));
let _e6652 = (_e6651 <= select(-1i, (_e6607 - select(0i, 1i, (_e6600 < f32(_e6607)))), (_e6558 <= _e852)));
if _e6652 {
let _e6658 = (((((f32(_e6651) + 0.5f) * 1f) - 0.5f) - _e6566) * _e407);
let _e6659 = (_e407 * 1f);
let _e6661 = (0.5f * _e6659);
let _e6662 = (_e6658 + _e6661);
let _e6663 = -(_e6662);
let _e6666 = (_e6645 - select(_e6663, _e6662, (_e6662 > _e6663)));
let _e6668 = select(0f, _e6666, (_e6666 > 0f));
let _e6670 = select(_e6643, _e6668, (_e6668 < _e6643));
let _e6673 = (_e6666 - _e6643);
let _e6677 = (((_e6670 * (_e6670 * _e6646)) + select(0f, _e6673, (_e6673 > 0f))) * _e6647);
let _e6681 = (_e6658 - _e6661);
let _e6682 = -(_e6681);
let _e6685 = (_e6645 - select(_e6682, _e6681, (_e6681 > _e6682)));
let _e6687 = select(0f, _e6685, (_e6685 > 0f));
let _e6689 = select(_e6643, _e6687, (_e6687 < _e6643));
let _e6692 = (_e6685 - _e6643);
let _e6696 = (((_e6689 * (_e6689 * _e6646)) + select(0f, _e6692, (_e6692 > 0f))) * _e6647);
if _e326 {
phi_15421_ = type_23(_e6651, _e6558);
} else {
phi_15421_ = type_23(_e6558, _e6651);
}
let _e6705 = phi_15421_;
let _e6711 = ((_e6705.member_1 * _e803) + _e6705.member);
let _e6713 = (bitcast<i32>(_e138) - 1i);
let _e6715 = select(_e6713, _e6711, (_e6711 < _e6713));
let _e6720 = global_4.member[bitcast<u32>(select(0i, _e6715, (_e6715 > 0i)))];
let _e6721 = (bitcast<i32>((_e799 * _e802)) + _e6711);
let _e6723 = select(_e6713, _e6721, (_e6721 < _e6713));
let _e6728 = global_4.member[bitcast<u32>(select(0i, _e6723, (_e6723 > 0i)))];
let _e6739 = global_1.member.member_2.member;
let _e6740 = (((((f32(_e6705.member) + 0.5f) / f32(_e803)) * 2f) - 1f) * _e6739);
let _e6747 = global_1.member.member_2.member_1;
let _e6748 = ((1f - (((f32(_e6705.member_1) + 0.5f) / f32(_e804)) * 2f)) * _e6747);
let _e6750 = global_1.member.member_3;
let _e6758 = global_1.member.member_4;
let _e6765 = ((_e6750.member * _e6740) + (_e6758.member * _e6748));
let _e6766 = ((_e6750.member_1 * _e6740) + (_e6758.member_1 * _e6748));
let _e6767 = ((_e6750.member_2 * _e6740) + (_e6758.member_2 * _e6748));
let _e6770 = global_1.member.member_2.member_3;
let _e6771 = (_e6770 != 0u);
let _e6773 = global_1.member.member_5;
let _e6780 = select((_e6773.member + _e6765), _e6773.member, _e6771);
let _e6781 = select((_e6773.member_1 + _e6766), _e6773.member_1, _e6771);
let _e6782 = select((_e6773.member_2 + _e6767), _e6773.member_2, _e6771);
let _e6784 = global_1.member.member_6;
let _e6798 = (((_e6780 * _e6780) + (_e6781 * _e6781)) + (_e6782 * _e6782));
let _e6801 = sqrt(select(0f, _e6798, (_e6798 > 0f)));
let _e6802 = (1f / _e6801);
let _e6803 = (_e6780 * _e6802);
let _e6804 = (_e6781 * _e6802);
let _e6805 = (_e6782 * _e6802);
let _e6806 = (_e444 - select(_e6784.member, (_e6784.member + _e6765), _e6771));
let _e6807 = (_e456 - select(_e6784.member_1, (_e6784.member_1 + _e6766), _e6771));
let _e6808 = (_e469 - select(_e6784.member_2, (_e6784.member_2 + _e6767), _e6771));
let _e6813 = (((_e6806 * _e6803) + (_e6807 * _e6804)) + (_e6808 * _e6805));
let _e6818 = (((_e6806 * _e482) + (_e6807 * _e495)) + (_e6808 * _e508));
let _e6823 = (((_e6803 * _e482) + (_e6804 * _e495)) + (_e6805 * _e508));
let _e6826 = ((_e6804 * _e508) - (_e6805 * _e495));
let _e6829 = ((_e6805 * _e482) - (_e6803 * _e508));
let _e6832 = ((_e6803 * _e495) - (_e6804 * _e482));
let _e6837 = (((_e6826 * _e6826) + (_e6829 * _e6829)) + (_e6832 * _e6832));
let _e6840 = (1f / select(1e-9f, _e6837, (_e6837 > 1e-9f)));
let _e6843 = ((_e6813 - (_e6823 * _e6818)) * _e6840);
let _e6846 = (((_e6823 * _e6813) - _e6818) * _e6840);
let _e6852 = (_e6843 - _e6728);
let _e6855 = (_e6846 + select(0f, _e6852, (_e6852 > 0f)));
let _e6858 = global_1.member.member_13.member;
let _e6863 = -((_e6858.member * _e6855));
let _e6865 = select(-87f, _e6863, (_e6863 > -87f));
let _e6867 = select(88f, _e6865, (_e6865 < 88f));
let _e6869 = ((_e6867 * 1.442695f) + 0.5f);
let _e6871 = select(-127f, _e6869, (_e6869 > -127f));
let _e6873 = select(128f, _e6871, (_e6871 < 128f));
let _e6880 = select(0i, select(select(i32(_e6873), i32(-2147483648), (_e6873 < -2147483600f)), 2147483647i, (_e6873 > 2147483500f)), (_e6873 == _e6873));
let _e6884 = (_e6880 - select(0i, 1i, (_e6873 < f32(_e6880))));
let _e6885 = f32(_e6884);
let _e6889 = ((_e6867 - (_e6885 * 0.6933594f)) - (_e6885 * -2.1219444e-4f));
let _e6911 = -((_e6858.member_1 * _e6855));
let _e6913 = select(-87f, _e6911, (_e6911 > -87f));
let _e6915 = select(88f, _e6913, (_e6913 < 88f));
let _e6917 = ((_e6915 * 1.442695f) + 0.5f);
let _e6919 = select(-127f, _e6917, (_e6917 > -127f));
let _e6921 = select(128f, _e6919, (_e6919 < 128f));
let _e6928 = select(0i, select(select(i32(_e6921), i32(-2147483648), (_e6921 < -2147483600f)), 2147483647i, (_e6921 > 2147483500f)), (_e6921 == _e6921));
let _e6932 = (_e6928 - select(0i, 1i, (_e6921 < f32(_e6928))));
let _e6933 = f32(_e6932);
let _e6937 = ((_e6915 - (_e6933 * 0.6933594f)) - (_e6933 * -2.1219444e-4f));
let _e6959 = -((_e6858.member_2 * _e6855));
let _e6961 = select(-87f, _e6959, (_e6959 > -87f));
let _e6963 = select(88f, _e6961, (_e6961 < 88f));
let _e6965 = ((_e6963 * 1.442695f) + 0.5f);
let _e6967 = select(-127f, _e6965, (_e6965 > -127f));
let _e6969 = select(128f, _e6967, (_e6967 < 128f));
let _e6976 = select(0i, select(select(i32(_e6969), i32(-2147483648), (_e6969 < -2147483600f)), 2147483647i, (_e6969 > 2147483500f)), (_e6969 == _e6969));
let _e6980 = (_e6976 - select(0i, 1i, (_e6969 < f32(_e6976))));
let _e6981 = f32(_e6980);
let _e6985 = ((_e6963 - (_e6981 * 0.6933594f)) - (_e6981 * -2.1219444e-4f));
let _e7006 = -(_e6823);
let _e7009 = global_1.member.member_13.member_2;
let _e7010 = (_e7009 * _e7009);
let _e7014 = ((1f + _e7010) - ((2f * _e7009) * _e7006));
let _e7016 = select(1e-9f, _e7014, (_e7014 > 1e-9f));
let _e7028 = global_1.member.member_13.member_3;
let _e7033 = (_e6801 * (select(((1f - _e7010) / (_e7016 * sqrt(select(0f, _e7016, (_e7016 > 0f))))), (0.75f * (1f + (_e7006 * _e7006))), (_e7028 == 1u)) * (0.25f / 3.1415927f)));
let _e7036 = global_1.member.member_13.member_1;
let _e7049 = select(0f, _e6843, (((_e6846 >= 0f) && (_e6846 < _e560)) && (_e6843 > 0f)));
if _e326 {
phi_15941_ = type_23(_e6651, _e6558);
} else {
phi_15941_ = type_23(_e6558, _e6651);
}
let _e7060 = phi_15941_;
let _e7063 = (_e6652 && (((_e7049 > 0f) && (_e7049 < _e6720)) && true));
let _e7066 = global_1.member.member_18.member;
let _e7067 = (((select(_e6677, (1f - _e6677), (_e6662 >= 0f)) - select(_e6696, (1f - _e6696), (_e6681 >= 0f))) * (1f / _e6659)) * _e7066);
let _e7071 = select(0f, (((((_e521 * _e7036.member) * ((1f + (_e6889 * (1f + (_e6889 * (0.5f + (_e6889 * (0.16666667f + (_e6889 * (0.041666668f + (_e6889 * (0.008333334f + (_e6889 * (0.001388889f + (_e6889 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6884 + 127i)) << bitcast<u32>(23i))))) * _e7033) * 1f) * _e7067), _e7063);
let _e7072 = select(0f, (((((_e534 * _e7036.member_1) * ((1f + (_e6937 * (1f + (_e6937 * (0.5f + (_e6937 * (0.16666667f + (_e6937 * (0.041666668f + (_e6937 * (0.008333334f + (_e6937 * (0.001388889f + (_e6937 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6932 + 127i)) << bitcast<u32>(23i))))) * _e7033) * 1f) * _e7067), _e7063);
let _e7073 = select(0f, (((((_e547 * _e7036.member_2) * ((1f + (_e6985 * (1f + (_e6985 * (0.5f + (_e6985 * (0.16666667f + (_e6985 * (0.041666668f + (_e6985 * (0.008333334f + (_e6985 * (0.001388889f + (_e6985 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6980 + 127i)) << bitcast<u32>(23i))))) * _e7033) * 1f) * _e7067), _e7063);
let _e7077 = (bitcast<f32>((bitcast<u32>(_e7071) & 2147483647u)) >= 1073741800f);
let _e7078 = (1f / 1048576f);
let _e7081 = ((_e7071 * select(1f, _e7078, _e7077)) + 0.5f);
let _e7083 = select(-1073741800f, _e7081, (_e7081 > -1073741800f));
let _e7085 = select(1073741800f, _e7083, (_e7083 < 1073741800f));
let _e7092 = select(0i, select(select(i32(_e7085), i32(-2147483648), (_e7085 < -2147483600f)), 2147483647i, (_e7085 > 2147483500f)), (_e7085 == _e7085));
let _e7096 = (_e7092 - select(0i, 1i, (_e7085 < f32(_e7092))));
let _e7097 = select(0i, 20i, _e7077);
let _e7101 = (bitcast<u32>(_e7096) << bitcast<u32>((_e7097 & 31i)));
let _e7108 = bitcast<u32>(((_e7096 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7097) & 31i))));
let _e7112 = (bitcast<f32>((bitcast<u32>(_e7072) & 2147483647u)) >= 1073741800f);
let _e7115 = ((_e7072 * select(1f, _e7078, _e7112)) + 0.5f);
let _e7117 = select(-1073741800f, _e7115, (_e7115 > -1073741800f));
let _e7119 = select(1073741800f, _e7117, (_e7117 < 1073741800f));
let _e7126 = select(0i, select(select(i32(_e7119), i32(-2147483648), (_e7119 < -2147483600f)), 2147483647i, (_e7119 > 2147483500f)), (_e7119 == _e7119));
let _e7130 = (_e7126 - select(0i, 1i, (_e7119 < f32(_e7126))));
let _e7131 = select(0i, 20i, _e7112);
let _e7135 = (bitcast<u32>(_e7130) << bitcast<u32>((_e7131 & 31i)));
let _e7142 = bitcast<u32>(((_e7130 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7131) & 31i))));
let _e7146 = (bitcast<f32>((bitcast<u32>(_e7073) & 2147483647u)) >= 1073741800f);
let _e7149 = ((_e7073 * select(1f, _e7078, _e7146)) + 0.5f);
let _e7151 = select(-1073741800f, _e7149, (_e7149 > -1073741800f));
let _e7153 = select(1073741800f, _e7151, (_e7151 < 1073741800f));
let _e7160 = select(0i, select(select(i32(_e7153), i32(-2147483648), (_e7153 < -2147483600f)), 2147483647i, (_e7153 > 2147483500f)), (_e7153 == _e7153));
let _e7164 = (_e7160 - select(0i, 1i, (_e7153 < f32(_e7160))));
let _e7165 = select(0i, 20i, _e7146);
let _e7169 = (bitcast<u32>(_e7164) << bitcast<u32>((_e7165 & 31i)));
let _e7176 = bitcast<u32>(((_e7164 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7165) & 31i))));
let _e7181 = bitcast<i32>(bitcast<u32>((((_e7060.member_1 * _e803) + _e7060.member) * 6i)));
if ((_e7101 | _e7108) == 0u) {
} else {
let _e7184 = bitcast<u32>(_e7181);
if (_e7184 < _e143) {
let _e7188 = atomicAdd((&global_6.member[_e7184]), _e7101);
phi_16174_ = _e7188;
} else {
phi_16174_ = 0u;
}
let _e7190 = phi_16174_;
let _e7194 = (_e7108 + select(0u, 1u, ((_e7190 + _e7101) < _e7101)));
if (_e7194 == 0u) {
} else {
let _e7196 = (_e7184 + 1u);
if (_e7196 < _e143) {
let _e7200 = atomicAdd((&global_6.member[_e7196]), _e7194);
}
}
}
if ((_e7135 | _e7142) == 0u) {
} else {
let _e7204 = bitcast<u32>((_e7181 + 2i));
if (_e7204 < _e143) {
let _e7208 = atomicAdd((&global_6.member[_e7204]), _e7135);
phi_16204_ = _e7208;
} else {
phi_16204_ = 0u;
}
let _e7210 = phi_16204_;
let _e7214 = (_e7142 + select(0u, 1u, ((_e7210 + _e7135) < _e7135)));
if (_e7214 == 0u) {
} else {
let _e7216 = (_e7204 + 1u);
if (_e7216 < _e143) {
let _e7220 = atomicAdd((&global_6.member[_e7216]), _e7214);
}
}
}
if ((_e7169 | _e7176) == 0u) {
} else {
let _e7224 = bitcast<u32>((_e7181 + 4i));
if (_e7224 < _e143) {
let _e7228 = atomicAdd((&global_6.member[_e7224]), _e7169);
phi_16234_ = _e7228;
} else {
phi_16234_ = 0u;
}
let _e7230 = phi_16234_;
let _e7234 = (_e7176 + select(0u, 1u, ((_e7230 + _e7169) < _e7169)));
if (_e7234 == 0u) {
} else {
let _e7236 = (_e7224 + 1u);
if (_e7236 < _e143) {
let _e7240 = atomicAdd((&global_6.member[_e7236]), _e7234);
}
}
}
phi_15317_ = (_e6649 + 1i);
} else {
phi_15317_ = i32();
}
let _e7243 = phi_15317_;
continue;
continuing {
phi_15316_ = _e7243;
break if !(_e6652);
}
}
phi_15163_ = (_e6555 + 1i);
} else {
phi_15163_ = i32();
}
let _e7247 = phi_15163_;
continue;
continuing {
phi_15162_ = _e7247;
break if !(_e6556);
}
}
} else {
if (_e6552 == 1u) {
phi_16283_ = 0i;
loop {
let _e7251 = phi_16283_;
let _e7252 = (_e7251 < 16i);
if _e7252 {
let _e7254 = (_e848 + (_e7251 & 15i));
let _e7256 = (f32(_e7254) + 0.5f);
let _e7258 = ((_e7256 * 1f) - 0.5f);
let _e7262 = (-(((_e289 * _e7258) + _e315)) / _e302);
let _e7269 = bitcast<f32>((bitcast<u32>(((_e339 * _e7258) + ((_e352 * _e7262) + _e365))) & 2147483647u));
let _e7276 = bitcast<f32>((bitcast<u32>(((_e378 * _e7258) + ((_e391 * _e7262) + _e404))) & 2147483647u));
let _e7280 = (((0.5f * (_e7269 + _e7276)) / _e407) + _e586);
let _e7281 = (1f / 1f);
let _e7289 = ((((_e7262 + _e7280) + 0.5f) * _e7281) - 0.5f);
let _e7290 = f32(_e6538);
let _e7291 = f32(_e6536);
let _e7292 = (_e7290 - 1f);
let _e7294 = select(_e7292, _e7289, (_e7289 > _e7292));
let _e7296 = select(_e7291, _e7294, (_e7294 < _e7291));
let _e7303 = select(0i, select(select(i32(_e7296), i32(-2147483648), (_e7296 < -2147483600f)), 2147483647i, (_e7296 > 2147483500f)), (_e7296 == _e7296));
let _e7308 = (((((_e7262 - _e7280) + 0.5f) * _e7281) - 0.5f) + 1f);
let _e7309 = (_e7291 + 1f);
let _e7311 = select(_e7290, _e7308, (_e7308 > _e7290));
let _e7313 = select(_e7309, _e7311, (_e7311 < _e7309));
let _e7320 = select(0i, select(select(i32(_e7313), i32(-2147483648), (_e7313 < -2147483600f)), 2147483647i, (_e7313 > 2147483500f)), (_e7313 == _e7313));
let _e7331 = ((1e-4f * 1f) * _e407);
let _e7333 = select(_e7276, _e7269, (_e7269 > _e7276));
let _e7335 = select(_e7331, _e7333, (_e7333 > _e7331));
let _e7337 = select(_e7276, _e7269, (_e7269 < _e7276));
let _e7339 = select(_e7331, _e7337, (_e7337 > _e7331));
let _e7341 = (0.5f * (_e7335 + _e7339));
let _e7342 = (0.5f / _e7339);
let _e7343 = (1f / _e7335);
phi_16437_ = 0i;
loop {
let _e7345 = phi_16437_;
let _e7347 = (((_e7320 - select(0i, 1i, (_e7313 < f32(_e7320)))) + (_e7251 >> bitcast<u32>(4u))) + bitcast<i32>(_e7345));
let _e7348 = (_e7347 <= select(-1i, (_e7303 - select(0i, 1i, (_e7296 < f32(_e7303)))), (_e7254 <= _e852)));
if _e7348 {
let _e7350 = (f32(_e7347) + 0.5f);
let _e7354 = ((((_e7350 * 1f) - 0.5f) - _e7262) * _e407);
let _e7355 = (_e407 * 1f);
let _e7357 = (0.5f * _e7355);
let _e7358 = (_e7354 + _e7357);
let _e7359 = -(_e7358);
let _e7362 = (_e7341 - select(_e7359, _e7358, (_e7358 > _e7359)));
let _e7364 = select(0f, _e7362, (_e7362 > 0f));
let _e7366 = select(_e7339, _e7364, (_e7364 < _e7339));
let _e7369 = (_e7362 - _e7339);
let _e7373 = (((_e7366 * (_e7366 * _e7342)) + select(0f, _e7369, (_e7369 > 0f))) * _e7343);
let _e7377 = (_e7354 - _e7357);
let _e7378 = -(_e7377);
let _e7381 = (_e7341 - select(_e7378, _e7377, (_e7377 > _e7378)));
let _e7383 = select(0f, _e7381, (_e7381 > 0f));
let _e7385 = select(_e7339, _e7383, (_e7383 < _e7339));
let _e7388 = (_e7381 - _e7339);
let _e7392 = (((_e7385 * (_e7385 * _e7342)) + select(0f, _e7388, (_e7388 > 0f))) * _e7343);
if _e326 {
phi_16542_ = type_23(_e7347, _e7254);
} else {
phi_16542_ = type_23(_e7254, _e7347);
}
let _e7401 = phi_16542_;
let _e7407 = ((_e7401.member_1 * _e803) + _e7401.member);
let _e7409 = (bitcast<i32>(_e138) - 1i);
let _e7411 = select(_e7409, _e7407, (_e7407 < _e7409));
let _e7416 = global_4.member[bitcast<u32>(select(0i, _e7411, (_e7411 > 0i)))];
let _e7417 = (bitcast<i32>((_e799 * _e802)) + _e7407);
let _e7419 = select(_e7409, _e7417, (_e7417 < _e7409));
let _e7424 = global_4.member[bitcast<u32>(select(0i, _e7419, (_e7419 > 0i)))];
let _e7427 = f32(_e803);
let _e7428 = f32(_e804);
let _e7435 = global_1.member.member_2.member;
let _e7436 = (((((f32(_e7401.member) + 0.5f) / _e7427) * 2f) - 1f) * _e7435);
let _e7443 = global_1.member.member_2.member_1;
let _e7444 = ((1f - (((f32(_e7401.member_1) + 0.5f) / _e7428) * 2f)) * _e7443);
let _e7446 = global_1.member.member_3;
let _e7454 = global_1.member.member_4;
let _e7461 = ((_e7446.member * _e7436) + (_e7454.member * _e7444));
let _e7462 = ((_e7446.member_1 * _e7436) + (_e7454.member_1 * _e7444));
let _e7463 = ((_e7446.member_2 * _e7436) + (_e7454.member_2 * _e7444));
let _e7466 = global_1.member.member_2.member_3;
let _e7467 = (_e7466 != 0u);
let _e7469 = global_1.member.member_5;
let _e7476 = select((_e7469.member + _e7461), _e7469.member, _e7467);
let _e7477 = select((_e7469.member_1 + _e7462), _e7469.member_1, _e7467);
let _e7478 = select((_e7469.member_2 + _e7463), _e7469.member_2, _e7467);
let _e7480 = global_1.member.member_6;
let _e7494 = (((_e7476 * _e7476) + (_e7477 * _e7477)) + (_e7478 * _e7478));
let _e7497 = sqrt(select(0f, _e7494, (_e7494 > 0f)));
let _e7498 = (1f / _e7497);
let _e7499 = (_e7476 * _e7498);
let _e7500 = (_e7477 * _e7498);
let _e7501 = (_e7478 * _e7498);
let _e7502 = (_e444 - select(_e7480.member, (_e7480.member + _e7461), _e7467));
let _e7503 = (_e456 - select(_e7480.member_1, (_e7480.member_1 + _e7462), _e7467));
let _e7504 = (_e469 - select(_e7480.member_2, (_e7480.member_2 + _e7463), _e7467));
let _e7509 = (((_e7502 * _e7499) + (_e7503 * _e7500)) + (_e7504 * _e7501));
let _e7514 = (((_e7502 * _e482) + (_e7503 * _e495)) + (_e7504 * _e508));
let _e7519 = (((_e7499 * _e482) + (_e7500 * _e495)) + (_e7501 * _e508));
let _e7522 = ((_e7500 * _e508) - (_e7501 * _e495));
let _e7525 = ((_e7501 * _e482) - (_e7499 * _e508));
let _e7528 = ((_e7499 * _e495) - (_e7500 * _e482));
let _e7533 = (((_e7522 * _e7522) + (_e7525 * _e7525)) + (_e7528 * _e7528));
let _e7536 = (1f / select(1e-9f, _e7533, (_e7533 > 1e-9f)));
let _e7539 = ((_e7509 - (_e7519 * _e7514)) * _e7536);
let _e7542 = (((_e7519 * _e7509) - _e7514) * _e7536);
let _e7548 = (_e7539 - _e7424);
let _e7551 = (_e7542 + select(0f, _e7548, (_e7548 > 0f)));
let _e7554 = global_1.member.member_13.member;
let _e7559 = -((_e7554.member * _e7551));
let _e7561 = select(-87f, _e7559, (_e7559 > -87f));
let _e7563 = select(88f, _e7561, (_e7561 < 88f));
let _e7565 = ((_e7563 * 1.442695f) + 0.5f);
let _e7567 = select(-127f, _e7565, (_e7565 > -127f));
let _e7569 = select(128f, _e7567, (_e7567 < 128f));
let _e7576 = select(0i, select(select(i32(_e7569), i32(-2147483648), (_e7569 < -2147483600f)), 2147483647i, (_e7569 > 2147483500f)), (_e7569 == _e7569));
let _e7580 = (_e7576 - select(0i, 1i, (_e7569 < f32(_e7576))));
let _e7581 = f32(_e7580);
let _e7585 = ((_e7563 - (_e7581 * 0.6933594f)) - (_e7581 * -2.1219444e-4f));
let _e7607 = -((_e7554.member_1 * _e7551));
let _e7609 = select(-87f, _e7607, (_e7607 > -87f));
let _e7611 = select(88f, _e7609, (_e7609 < 88f));
let _e7613 = ((_e7611 * 1.442695f) + 0.5f);
let _e7615 = select(-127f, _e7613, (_e7613 > -127f));
let _e7617 = select(128f, _e7615, (_e7615 < 128f));
let _e7624 = select(0i, select(select(i32(_e7617), i32(-2147483648), (_e7617 < -2147483600f)), 2147483647i, (_e7617 > 2147483500f)), (_e7617 == _e7617));
let _e7628 = (_e7624 - select(0i, 1i, (_e7617 < f32(_e7624))));
let _e7629 = f32(_e7628);
let _e7633 = ((_e7611 - (_e7629 * 0.6933594f)) - (_e7629 * -2.1219444e-4f));
let _e7655 = -((_e7554.member_2 * _e7551));
let _e7657 = select(-87f, _e7655, (_e7655 > -87f));
let _e7659 = select(88f, _e7657, (_e7657 < 88f));
let _e7661 = ((_e7659 * 1.442695f) + 0.5f);
let _e7663 = select(-127f, _e7661, (_e7661 > -127f));
let _e7665 = select(128f, _e7663, (_e7663 < 128f));
let _e7672 = select(0i, select(select(i32(_e7665), i32(-2147483648), (_e7665 < -2147483600f)), 2147483647i, (_e7665 > 2147483500f)), (_e7665 == _e7665));
let _e7676 = (_e7672 - select(0i, 1i, (_e7665 < f32(_e7672))));
let _e7677 = f32(_e7676);
let _e7681 = ((_e7659 - (_e7677 * 0.6933594f)) - (_e7677 * -2.1219444e-4f));
let _e7702 = -(_e7519);
let _e7705 = global_1.member.member_13.member_2;
let _e7706 = (_e7705 * _e7705);
let _e7710 = ((1f + _e7706) - ((2f * _e7705) * _e7702));
let _e7712 = select(1e-9f, _e7710, (_e7710 > 1e-9f));
let _e7724 = global_1.member.member_13.member_3;
let _e7729 = (_e7497 * (select(((1f - _e7706) / (_e7712 * sqrt(select(0f, _e7712, (_e7712 > 0f))))), (0.75f * (1f + (_e7702 * _e7702))), (_e7724 == 1u)) * (0.25f / 3.1415927f)));
let _e7732 = global_1.member.member_13.member_1;
let _e7745 = select(0f, _e7539, (((_e7542 >= 0f) && (_e7542 < _e560)) && (_e7539 > 0f)));
let _e7747 = ((_e635 + _e6540) + _e6544);
let _e7748 = (_e7747 & 31u);
let _e7750 = (1u << bitcast<u32>(_e7748));
let _e7759 = bitcast<i32>((((_e799 + _e7750) - 1u) >> bitcast<u32>(_e7748)));
let _e7760 = bitcast<i32>((((_e802 + _e7750) - 1u) >> bitcast<u32>(_e7748)));
if _e326 {
phi_17088_ = type_23(_e7760, _e7759);
} else {
phi_17088_ = type_23(_e7759, _e7760);
}
let _e7764 = phi_17088_;
let _e7769 = f32((1i << bitcast<u32>(_e7748)));
let _e7770 = (1f / _e7769);
let _e7772 = ((_e7256 * _e7770) - 0.5f);
let _e7774 = ((_e7350 * _e7770) - 0.5f);
let _e7776 = select(-1f, _e7772, (_e7772 > -1f));
let _e7778 = select(1e6f, _e7776, (_e7776 < 1e6f));
let _e7785 = select(0i, select(select(i32(_e7778), i32(-2147483648), (_e7778 < -2147483600f)), 2147483647i, (_e7778 > 2147483500f)), (_e7778 == _e7778));
let _e7789 = (_e7785 - select(0i, 1i, (_e7778 < f32(_e7785))));
let _e7791 = select(-1f, _e7774, (_e7774 > -1f));
let _e7793 = select(1e6f, _e7791, (_e7791 < 1e6f));
let _e7800 = select(0i, select(select(i32(_e7793), i32(-2147483648), (_e7793 < -2147483600f)), 2147483647i, (_e7793 > 2147483500f)), (_e7793 == _e7793));
let _e7804 = (_e7800 - select(0i, 1i, (_e7793 < f32(_e7800))));
let _e7806 = (_e7772 - f32(_e7789));
let _e7808 = (_e7774 - f32(_e7804));
let _e7809 = (1f - _e7806);
let _e7810 = (1f - _e7808);
let _e7813 = select(_e7789, 0i, (_e7789 < 0i));
let _e7814 = (_e7813 >= _e7764.member);
if _e7814 {
phi_17166_ = (_e7764.member - 1i);
} else {
phi_17166_ = _e7813;
}
let _e7817 = phi_17166_;
let _e7819 = select(_e7804, 0i, (_e7804 < 0i));
let _e7820 = (_e7819 >= _e7764.member_1);
if _e7820 {
phi_17177_ = (_e7764.member_1 - 1i);
} else {
phi_17177_ = _e7819;
}
let _e7823 = phi_17177_;
let _e7827 = (((f32(_e7817) + 0.5f) * _e7769) - 0.5f);
let _e7831 = (((f32(_e7823) + 0.5f) * _e7769) - 0.5f);
if _e326 {
phi_17205_ = type_23(_e7823, _e7817);
} else {
phi_17205_ = type_23(_e7817, _e7823);
}
let _e7837 = phi_17205_;
let _e7843 = bitcast<i32>(((_e799 + 1u) >> bitcast<u32>(1u)));
let _e7846 = global_1.member.member_18.member_6;
let _e7849 = global_1.member.member_18.member_7;
let _e7852 = global_1.member.member_18.member_8;
let _e7853 = (_e7747 == 0u);
if _e7853 {
phi_17256_ = 0u;
} else {
if (_e7747 == 1u) {
phi_17255_ = 0u;
} else {
if (_e7747 == 2u) {
phi_17254_ = _e7846;
} else {
phi_17254_ = select(_e7852, _e7849, (_e7747 == 3u));
}
let _e7859 = phi_17254_;
phi_17255_ = _e7859;
}
let _e7861 = phi_17255_;
phi_17256_ = _e7861;
}
let _e7863 = phi_17256_;
local_30 = (((bitcast<i32>(_e7863) + _e7837.member_1) * _e7843) + _e7837.member);
let _e7868 = local_30;
let _e7870 = (bitcast<i32>(_e141) - 1i);
let _e7872 = select(_e7870, _e7868, (_e7868 < _e7870));
let _e7877 = global_5.member[bitcast<u32>(select(0i, _e7872, (_e7872 > 0i)))];
let _e7882 = (((((select(_e7827, _e7831, _e326) + 0.5f) / _e7427) * 2f) - 1f) * _e7435);
let _e7887 = ((1f - (((select(_e7831, _e7827, _e326) + 0.5f) / _e7428) * 2f)) * _e7443);
let _e7894 = ((_e7446.member * _e7882) + (_e7454.member * _e7887));
let _e7895 = ((_e7446.member_1 * _e7882) + (_e7454.member_1 * _e7887));
let _e7896 = ((_e7446.member_2 * _e7882) + (_e7454.member_2 * _e7887));
let _e7900 = select((_e7469.member + _e7894), _e7469.member, _e7467);
let _e7901 = select((_e7469.member_1 + _e7895), _e7469.member_1, _e7467);
let _e7902 = select((_e7469.member_2 + _e7896), _e7469.member_2, _e7467);
let _e7913 = (((_e7900 * _e7900) + (_e7901 * _e7901)) + (_e7902 * _e7902));
let _e7917 = (1f / sqrt(select(0f, _e7913, (_e7913 > 0f))));
let _e7918 = (_e7900 * _e7917);
let _e7919 = (_e7901 * _e7917);
let _e7920 = (_e7902 * _e7917);
let _e7921 = (_e444 - select(_e7480.member, (_e7480.member + _e7894), _e7467));
let _e7922 = (_e456 - select(_e7480.member_1, (_e7480.member_1 + _e7895), _e7467));
let _e7923 = (_e469 - select(_e7480.member_2, (_e7480.member_2 + _e7896), _e7467));
let _e7928 = (((_e7921 * _e7918) + (_e7922 * _e7919)) + (_e7923 * _e7920));
let _e7933 = (((_e7921 * _e482) + (_e7922 * _e495)) + (_e7923 * _e508));
let _e7938 = (((_e7918 * _e482) + (_e7919 * _e495)) + (_e7920 * _e508));
let _e7941 = ((_e7919 * _e508) - (_e7920 * _e495));
let _e7944 = ((_e7920 * _e482) - (_e7918 * _e508));
let _e7947 = ((_e7918 * _e495) - (_e7919 * _e482));
let _e7952 = (((_e7941 * _e7941) + (_e7944 * _e7944)) + (_e7947 * _e7947));
let _e7955 = (1f / select(1e-9f, _e7952, (_e7952 > 1e-9f)));
let _e7958 = ((_e7928 - (_e7938 * _e7933)) * _e7955);
let _e7961 = (((_e7938 * _e7928) - _e7933) * _e7955);
let _e7967 = select(0f, _e7958, (((_e7961 >= 0f) && (_e7961 < _e560)) && (_e7958 > 0f)));
let _e7969 = (_e7817 << bitcast<u32>(_e7748));
let _e7981 = (_e7789 + 1i);
let _e7984 = select(_e7981, 0i, (_e7981 < 0i));
let _e7985 = (_e7984 >= _e7764.member);
if _e7985 {
phi_17673_ = (_e7764.member - 1i);
} else {
phi_17673_ = _e7984;
}
let _e7988 = phi_17673_;
if _e7820 {
phi_17684_ = (_e7764.member_1 - 1i);
} else {
phi_17684_ = _e7819;
}
let _e7991 = phi_17684_;
let _e7995 = (((f32(_e7988) + 0.5f) * _e7769) - 0.5f);
let _e7999 = (((f32(_e7991) + 0.5f) * _e7769) - 0.5f);
if _e326 {
phi_17712_ = type_23(_e7991, _e7988);
} else {
phi_17712_ = type_23(_e7988, _e7991);
}
let _e8005 = phi_17712_;
if _e7853 {
phi_17763_ = 0u;
} else {
if (_e7747 == 1u) {
phi_17762_ = 0u;
} else {
if (_e7747 == 2u) {
phi_17761_ = _e7846;
} else {
phi_17761_ = select(_e7852, _e7849, (_e7747 == 3u));
}
let _e8013 = phi_17761_;
phi_17762_ = _e8013;
}
let _e8015 = phi_17762_;
phi_17763_ = _e8015;
}
let _e8017 = phi_17763_;
local_28 = (((bitcast<i32>(_e8017) + _e8005.member_1) * _e7843) + _e8005.member);
let _e8022 = local_28;
let _e8024 = select(_e7870, _e8022, (_e8022 < _e7870));
let _e8029 = global_5.member[bitcast<u32>(select(0i, _e8024, (_e8024 > 0i)))];
let _e8034 = (((((select(_e7995, _e7999, _e326) + 0.5f) / _e7427) * 2f) - 1f) * _e7435);
let _e8039 = ((1f - (((select(_e7999, _e7995, _e326) + 0.5f) / _e7428) * 2f)) * _e7443);
let _e8046 = ((_e7446.member * _e8034) + (_e7454.member * _e8039));
let _e8047 = ((_e7446.member_1 * _e8034) + (_e7454.member_1 * _e8039));
let _e8048 = ((_e7446.member_2 * _e8034) + (_e7454.member_2 * _e8039));
let _e8052 = select((_e7469.member + _e8046), _e7469.member, _e7467);
let _e8053 = select((_e7469.member_1 + _e8047), _e7469.member_1, _e7467);
let _e8054 = select((_e7469.member_2 + _e8048), _e7469.member_2, _e7467);
let _e8065 = (((_e8052 * _e8052) + (_e8053 * _e8053)) + (_e8054 * _e8054));
let _e8069 = (1f / sqrt(select(0f, _e8065, (_e8065 > 0f))));
let _e8070 = (_e8052 * _e8069);
let _e8071 = (_e8053 * _e8069);
let _e8072 = (_e8054 * _e8069);
let _e8073 = (_e444 - select(_e7480.member, (_e7480.member + _e8046), _e7467));
let _e8074 = (_e456 - select(_e7480.member_1, (_e7480.member_1 + _e8047), _e7467));
let _e8075 = (_e469 - select(_e7480.member_2, (_e7480.member_2 + _e8048), _e7467));
let _e8080 = (((_e8073 * _e8070) + (_e8074 * _e8071)) + (_e8075 * _e8072));
let _e8085 = (((_e8073 * _e482) + (_e8074 * _e495)) + (_e8075 * _e508));
let _e8090 = (((_e8070 * _e482) + (_e8071 * _e495)) + (_e8072 * _e508));
let _e8093 = ((_e8071 * _e508) - (_e8072 * _e495));
let _e8096 = ((_e8072 * _e482) - (_e8070 * _e508));
let _e8099 = ((_e8070 * _e495) - (_e8071 * _e482));
let _e8104 = (((_e8093 * _e8093) + (_e8096 * _e8096)) + (_e8099 * _e8099));
let _e8107 = (1f / select(1e-9f, _e8104, (_e8104 > 1e-9f)));
let _e8110 = ((_e8080 - (_e8090 * _e8085)) * _e8107);
let _e8113 = (((_e8090 * _e8080) - _e8085) * _e8107);
let _e8119 = select(0f, _e8110, (((_e8113 >= 0f) && (_e8113 < _e560)) && (_e8110 > 0f)));
let _e8121 = (_e7988 << bitcast<u32>(_e7748));
let _e8133 = (_e7804 + 1i);
if _e7814 {
phi_18180_ = (_e7764.member - 1i);
} else {
phi_18180_ = _e7813;
}
let _e8137 = phi_18180_;
let _e8139 = select(_e8133, 0i, (_e8133 < 0i));
let _e8140 = (_e8139 >= _e7764.member_1);
if _e8140 {
phi_18191_ = (_e7764.member_1 - 1i);
} else {
phi_18191_ = _e8139;
}
let _e8143 = phi_18191_;
let _e8147 = (((f32(_e8137) + 0.5f) * _e7769) - 0.5f);
let _e8151 = (((f32(_e8143) + 0.5f) * _e7769) - 0.5f);
if _e326 {
phi_18219_ = type_23(_e8143, _e8137);
} else {
phi_18219_ = type_23(_e8137, _e8143);
}
let _e8157 = phi_18219_;
if _e7853 {
phi_18270_ = 0u;
} else {
if (_e7747 == 1u) {
phi_18269_ = 0u;
} else {
if (_e7747 == 2u) {
phi_18268_ = _e7846;
} else {
phi_18268_ = select(_e7852, _e7849, (_e7747 == 3u));
}
let _e8165 = phi_18268_;
phi_18269_ = _e8165;
}
let _e8167 = phi_18269_;
phi_18270_ = _e8167;
}
let _e8169 = phi_18270_;
local_26 = (((bitcast<i32>(_e8169) + _e8157.member_1) * _e7843) + _e8157.member);
let _e8174 = local_26;
let _e8176 = select(_e7870, _e8174, (_e8174 < _e7870));
let _e8181 = global_5.member[bitcast<u32>(select(0i, _e8176, (_e8176 > 0i)))];
let _e8186 = (((((select(_e8147, _e8151, _e326) + 0.5f) / _e7427) * 2f) - 1f) * _e7435);
let _e8191 = ((1f - (((select(_e8151, _e8147, _e326) + 0.5f) / _e7428) * 2f)) * _e7443);
let _e8198 = ((_e7446.member * _e8186) + (_e7454.member * _e8191));
let _e8199 = ((_e7446.member_1 * _e8186) + (_e7454.member_1 * _e8191));
let _e8200 = ((_e7446.member_2 * _e8186) + (_e7454.member_2 * _e8191));
let _e8204 = select((_e7469.member + _e8198), _e7469.member, _e7467);
let _e8205 = select((_e7469.member_1 + _e8199), _e7469.member_1, _e7467);
let _e8206 = select((_e7469.member_2 + _e8200), _e7469.member_2, _e7467);
let _e8217 = (((_e8204 * _e8204) + (_e8205 * _e8205)) + (_e8206 * _e8206));
let _e8221 = (1f / sqrt(select(0f, _e8217, (_e8217 > 0f))));
let _e8222 = (_e8204 * _e8221);
let _e8223 = (_e8205 * _e8221);
let _e8224 = (_e8206 * _e8221);
let _e8225 = (_e444 - select(_e7480.member, (_e7480.member + _e8198), _e7467));
let _e8226 = (_e456 - select(_e7480.member_1, (_e7480.member_1 + _e8199), _e7467));
let _e8227 = (_e469 - select(_e7480.member_2, (_e7480.member_2 + _e8200), _e7467));
let _e8232 = (((_e8225 * _e8222) + (_e8226 * _e8223)) + (_e8227 * _e8224));
let _e8237 = (((_e8225 * _e482) + (_e8226 * _e495)) + (_e8227 * _e508));
let _e8242 = (((_e8222 * _e482) + (_e8223 * _e495)) + (_e8224 * _e508));
let _e8245 = ((_e8223 * _e508) - (_e8224 * _e495));
let _e8248 = ((_e8224 * _e482) - (_e8222 * _e508));
let _e8251 = ((_e8222 * _e495) - (_e8223 * _e482));
let _e8256 = (((_e8245 * _e8245) + (_e8248 * _e8248)) + (_e8251 * _e8251));
let _e8259 = (1f / select(1e-9f, _e8256, (_e8256 > 1e-9f)));
let _e8262 = ((_e8232 - (_e8242 * _e8237)) * _e8259);
let _e8265 = (((_e8242 * _e8232) - _e8237) * _e8259);
let _e8271 = select(0f, _e8262, (((_e8265 >= 0f) && (_e8265 < _e560)) && (_e8262 > 0f)));
let _e8273 = (_e8137 << bitcast<u32>(_e7748));
if _e7985 {
phi_18687_ = (_e7764.member - 1i);
} else {
phi_18687_ = _e7984;
}
let _e8288 = phi_18687_;
if _e8140 {
phi_18698_ = (_e7764.member_1 - 1i);
} else {
phi_18698_ = _e8139;
}
let _e8291 = phi_18698_;
let _e8295 = (((f32(_e8288) + 0.5f) * _e7769) - 0.5f);
let _e8299 = (((f32(_e8291) + 0.5f) * _e7769) - 0.5f);
if _e326 {
phi_18726_ = type_23(_e8291, _e8288);
} else {
phi_18726_ = type_23(_e8288, _e8291);
}
let _e8305 = phi_18726_;
if _e7853 {
phi_18777_ = 0u;
} else {
if (_e7747 == 1u) {
phi_18776_ = 0u;
} else {
if (_e7747 == 2u) {
phi_18775_ = _e7846;
} else {
phi_18775_ = select(_e7852, _e7849, (_e7747 == 3u));
}
let _e8313 = phi_18775_;
phi_18776_ = _e8313;
}
let _e8315 = phi_18776_;
phi_18777_ = _e8315;
}
let _e8317 = phi_18777_;
local_24 = (((bitcast<i32>(_e8317) + _e8305.member_1) * _e7843) + _e8305.member);
let _e8322 = local_24;
let _e8324 = select(_e7870, _e8322, (_e8322 < _e7870));
let _e8329 = global_5.member[bitcast<u32>(select(0i, _e8324, (_e8324 > 0i)))];
let _e8334 = (((((select(_e8295, _e8299, _e326) + 0.5f) / _e7427) * 2f) - 1f) * _e7435);
let _e8339 = ((1f - (((select(_e8299, _e8295, _e326) + 0.5f) / _e7428) * 2f)) * _e7443);
let _e8346 = ((_e7446.member * _e8334) + (_e7454.member * _e8339));
let _e8347 = ((_e7446.member_1 * _e8334) + (_e7454.member_1 * _e8339));
let _e8348 = ((_e7446.member_2 * _e8334) + (_e7454.member_2 * _e8339));
let _e8352 = select((_e7469.member + _e8346), _e7469.member, _e7467);
let _e8353 = select((_e7469.member_1 + _e8347), _e7469.member_1, _e7467);
let _e8354 = select((_e7469.member_2 + _e8348), _e7469.member_2, _e7467);
let _e8365 = (((_e8352 * _e8352) + (_e8353 * _e8353)) + (_e8354 * _e8354));
let _e8369 = (1f / sqrt(select(0f, _e8365, (_e8365 > 0f))));
let _e8370 = (_e8352 * _e8369);
let _e8371 = (_e8353 * _e8369);
let _e8372 = (_e8354 * _e8369);
let _e8373 = (_e444 - select(_e7480.member, (_e7480.member + _e8346), _e7467));
let _e8374 = (_e456 - select(_e7480.member_1, (_e7480.member_1 + _e8347), _e7467));
let _e8375 = (_e469 - select(_e7480.member_2, (_e7480.member_2 + _e8348), _e7467));
let _e8380 = (((_e8373 * _e8370) + (_e8374 * _e8371)) + (_e8375 * _e8372));
let _e8385 = (((_e8373 * _e482) + (_e8374 * _e495)) + (_e8375 * _e508));
let _e8390 = (((_e8370 * _e482) + (_e8371 * _e495)) + (_e8372 * _e508));
let _e8393 = ((_e8371 * _e508) - (_e8372 * _e495));
let _e8396 = ((_e8372 * _e482) - (_e8370 * _e508));
let _e8399 = ((_e8370 * _e495) - (_e8371 * _e482));
let _e8404 = (((_e8393 * _e8393) + (_e8396 * _e8396)) + (_e8399 * _e8399));
let _e8407 = (1f / select(1e-9f, _e8404, (_e8404 > 1e-9f)));
let _e8410 = ((_e8380 - (_e8390 * _e8385)) * _e8407);
let _e8413 = (((_e8390 * _e8380) - _e8385) * _e8407);
let _e8419 = select(0f, _e8410, (((_e8413 >= 0f) && (_e8413 < _e560)) && (_e8410 > 0f)));
let _e8421 = (_e8288 << bitcast<u32>(_e7748));
let _e8433 = select(((((1f - select(0f, (_e7809 * _e7810), (((select(select(_e635, _e796, (_e7969 >= _e561)), _e716, (_e7969 < _e171)) == _e7747) && (_e7967 > 0f)) && (_e7967 < _e7877)))) - select(0f, (_e7806 * _e7810), (((select(select(_e635, _e796, (_e8121 >= _e561)), _e716, (_e8121 < _e171)) == _e7747) && (_e8119 > 0f)) && (_e8119 < _e8029)))) - select(0f, (_e7809 * _e7808), (((select(select(_e635, _e796, (_e8273 >= _e561)), _e716, (_e8273 < _e171)) == _e7747) && (_e8271 > 0f)) && (_e8271 < _e8181)))) - select(0f, (_e7806 * _e7808), (((select(select(_e635, _e796, (_e8421 >= _e561)), _e716, (_e8421 < _e171)) == _e7747) && (_e8419 > 0f)) && (_e8419 < _e8329)))), 1f, _e7853);
if _e326 {
phi_19203_ = type_23(_e7347, _e7254);
} else {
phi_19203_ = type_23(_e7254, _e7347);
}
let _e8448 = phi_19203_;
let _e8451 = (_e7348 && (((_e7745 > 0f) && (_e7745 < _e7416)) && (bitcast<f32>((bitcast<u32>(_e8433) & 2147483647u)) > 1e-6f)));
let _e8454 = global_1.member.member_18.member;
let _e8455 = (((select(_e7373, (1f - _e7373), (_e7358 >= 0f)) - select(_e7392, (1f - _e7392), (_e7377 >= 0f))) * (1f / _e7355)) * _e8454);
let _e8459 = select(0f, (((((_e521 * _e7732.member) * ((1f + (_e7585 * (1f + (_e7585 * (0.5f + (_e7585 * (0.16666667f + (_e7585 * (0.041666668f + (_e7585 * (0.008333334f + (_e7585 * (0.001388889f + (_e7585 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7580 + 127i)) << bitcast<u32>(23i))))) * _e7729) * _e8433) * _e8455), _e8451);
let _e8460 = select(0f, (((((_e534 * _e7732.member_1) * ((1f + (_e7633 * (1f + (_e7633 * (0.5f + (_e7633 * (0.16666667f + (_e7633 * (0.041666668f + (_e7633 * (0.008333334f + (_e7633 * (0.001388889f + (_e7633 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7628 + 127i)) << bitcast<u32>(23i))))) * _e7729) * _e8433) * _e8455), _e8451);
let _e8461 = select(0f, (((((_e547 * _e7732.member_2) * ((1f + (_e7681 * (1f + (_e7681 * (0.5f + (_e7681 * (0.16666667f + (_e7681 * (0.041666668f + (_e7681 * (0.008333334f + (_e7681 * (0.001388889f + (_e7681 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7676 + 127i)) << bitcast<u32>(23i))))) * _e7729) * _e8433) * _e8455), _e8451);
let _e8465 = (bitcast<f32>((bitcast<u32>(_e8459) & 2147483647u)) >= 1073741800f);
let _e8466 = (1f / 1048576f);
let _e8469 = ((_e8459 * select(1f, _e8466, _e8465)) + 0.5f);
let _e8471 = select(-1073741800f, _e8469, (_e8469 > -1073741800f));
let _e8473 = select(1073741800f, _e8471, (_e8471 < 1073741800f));
let _e8480 = select(0i, select(select(i32(_e8473), i32(-2147483648), (_e8473 < -2147483600f)), 2147483647i, (_e8473 > 2147483500f)), (_e8473 == _e8473));
let _e8484 = (_e8480 - select(0i, 1i, (_e8473 < f32(_e8480))));
let _e8485 = select(0i, 20i, _e8465);
let _e8489 = (bitcast<u32>(_e8484) << bitcast<u32>((_e8485 & 31i)));
let _e8496 = bitcast<u32>(((_e8484 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8485) & 31i))));
let _e8500 = (bitcast<f32>((bitcast<u32>(_e8460) & 2147483647u)) >= 1073741800f);
let _e8503 = ((_e8460 * select(1f, _e8466, _e8500)) + 0.5f);
let _e8505 = select(-1073741800f, _e8503, (_e8503 > -1073741800f));
let _e8507 = select(1073741800f, _e8505, (_e8505 < 1073741800f));
let _e8514 = select(0i, select(select(i32(_e8507), i32(-2147483648), (_e8507 < -2147483600f)), 2147483647i, (_e8507 > 2147483500f)), (_e8507 == _e8507));
let _e8518 = (_e8514 - select(0i, 1i, (_e8507 < f32(_e8514))));
let _e8519 = select(0i, 20i, _e8500);
let _e8523 = (bitcast<u32>(_e8518) << bitcast<u32>((_e8519 & 31i)));
let _e8530 = bitcast<u32>(((_e8518 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8519) & 31i))));
let _e8534 = (bitcast<f32>((bitcast<u32>(_e8461) & 2147483647u)) >= 1073741800f);
let _e8537 = ((_e8461 * select(1f, _e8466, _e8534)) + 0.5f);
let _e8539 = select(-1073741800f, _e8537, (_e8537 > -1073741800f));
let _e8541 = select(1073741800f, _e8539, (_e8539 < 1073741800f));
let _e8548 = select(0i, select(select(i32(_e8541), i32(-2147483648), (_e8541 < -2147483600f)), 2147483647i, (_e8541 > 2147483500f)), (_e8541 == _e8541));
let _e8552 = (_e8548 - select(0i, 1i, (_e8541 < f32(_e8548))));
let _e8553 = select(0i, 20i, _e8534);
let _e8557 = (bitcast<u32>(_e8552) << bitcast<u32>((_e8553 & 31i)));
let _e8564 = bitcast<u32>(((_e8552 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8553) & 31i))));
let _e8569 = bitcast<i32>(bitcast<u32>((((_e8448.member_1 * _e803) + _e8448.member) * 6i)));
if ((_e8489 | _e8496) == 0u) {
} else {
let _e8572 = bitcast<u32>(_e8569);
if (_e8572 < _e143) {
let _e8576 = atomicAdd((&global_6.member[_e8572]), _e8489);
phi_19436_ = _e8576;
} else {
phi_19436_ = 0u;
}
let _e8578 = phi_19436_;
let _e8582 = (_e8496 + select(0u, 1u, ((_e8578 + _e8489) < _e8489)));
if (_e8582 == 0u) {
} else {
let _e8584 = (_e8572 + 1u);
if (_e8584 < _e143) {
let _e8588 = atomicAdd((&global_6.member[_e8584]), _e8582);
}
}
}
if ((_e8523 | _e8530) == 0u) {
} else {
let _e8592 = bitcast<u32>((_e8569 + 2i));
if (_e8592 < _e143) {
let _e8596 = atomicAdd((&global_6.member[_e8592]), _e8523);
phi_19466_ = _e8596;
} else {
phi_19466_ = 0u;
}
let _e8598 = phi_19466_;
let _e8602 = (_e8530 + select(0u, 1u, ((_e8598 + _e8523) < _e8523)));
if (_e8602 == 0u) {
} else {
let _e8604 = (_e8592 + 1u);
if (_e8604 < _e143) {
let _e8608 = atomicAdd((&global_6.member[_e8604]), _e8602);
}
}
}
if ((_e8557 | _e8564) == 0u) {
} else {
let _e8612 = bitcast<u32>((_e8569 + 4i));
if (_e8612 < _e143) {
let _e8616 = atomicAdd((&global_6.member[_e8612]), _e8557);
phi_19496_ = _e8616;
} else {
phi_19496_ = 0u;
}
let _e8618 = phi_19496_;
let _e8622 = (_e8564 + select(0u, 1u, ((_e8618 + _e8557) < _e8557)));
if (_e8622 == 0u) {
} else {
let _e8624 = (_e8612 + 1u);
if (_e8624 < _e143) {
let _e8628 = atomicAdd((&global_6.member[_e8624]), _e8622);
}
}
}
phi_16438_ = (_e7345 + 1i);
} else {
phi_16438_ = i32();
}
let _e8631 = phi_16438_;
continue;
continuing {
phi_16437_ = _e8631;
break if !(_e7348);
}
}
phi_16284_ = (_e7251 + 1i);
} else {
phi_16284_ = i32();
}
let _e8635 = phi_16284_;
continue;
continuing {
phi_16283_ = _e8635;
break if !(_e7252);
}
}
} else {
phi_19541_ = 0i;
loop {
let _e8638 = phi_19541_;
let _e8639 = (_e8638 < 16i);
if _e8639 {
let _e8641 = (_e848 + (_e8638 & 15i));
let _e8643 = (f32(_e8641) + 0.5f);
let _e8645 = ((_e8643 * 1f) - 0.5f);
let _e8649 = (-(((_e289 * _e8645) + _e315)) / _e302);
let _e8656 = bitcast<f32>((bitcast<u32>(((_e339 * _e8645) + ((_e352 * _e8649) + _e365))) & 2147483647u));
let _e8663 = bitcast<f32>((bitcast<u32>(((_e378 * _e8645) + ((_e391 * _e8649) + _e404))) & 2147483647u));
let _e8667 = (((0.5f * (_e8656 + _e8663)) / _e407) + _e586);
let _e8668 = (1f / 1f);
let _e8676 = ((((_e8649 + _e8667) + 0.5f) * _e8668) - 0.5f);
let _e8677 = f32(_e6538);
let _e8678 = f32(_e6536);
let _e8679 = (_e8677 - 1f);
let _e8681 = select(_e8679, _e8676, (_e8676 > _e8679));
let _e8683 = select(_e8678, _e8681, (_e8681 < _e8678));
let _e8690 = select(0i, select(select(i32(_e8683), i32(-2147483648), (_e8683 < -2147483600f)), 2147483647i, (_e8683 > 2147483500f)), (_e8683 == _e8683));
let _e8695 = (((((_e8649 - _e8667) + 0.5f) * _e8668) - 0.5f) + 1f);
let _e8696 = (_e8678 + 1f);
let _e8698 = select(_e8677, _e8695, (_e8695 > _e8677));
let _e8700 = select(_e8696, _e8698, (_e8698 < _e8696));
let _e8707 = select(0i, select(select(i32(_e8700), i32(-2147483648), (_e8700 < -2147483600f)), 2147483647i, (_e8700 > 2147483500f)), (_e8700 == _e8700));
let _e8718 = ((1e-4f * 1f) * _e407);
let _e8720 = select(_e8663, _e8656, (_e8656 > _e8663));
let _e8722 = select(_e8718, _e8720, (_e8720 > _e8718));
let _e8724 = select(_e8663, _e8656, (_e8656 < _e8663));
let _e8726 = select(_e8718, _e8724, (_e8724 > _e8718));
let _e8728 = (0.5f * (_e8722 + _e8726));
let _e8729 = (0.5f / _e8726);
let _e8730 = (1f / _e8722);
phi_19695_ = 0i;
loop {
let _e8732 = phi_19695_;
let _e8734 = (((_e8707 - select(0i, 1i, (_e8700 < f32(_e8707)))) + (_e8638 >> bitcast<u32>(4u))) + bitcast<i32>(_e8732));
let _e8735 = (_e8734 <= select(-1i, (_e8690 - select(0i, 1i, (_e8683 < f32(_e8690)))), (_e8641 <= _e852)));
if _e8735 {
let _e8737 = (f32(_e8734) + 0.5f);
let _e8741 = ((((_e8737 * 1f) - 0.5f) - _e8649) * _e407);
let _e8742 = (_e407 * 1f);
let _e8744 = (0.5f * _e8742);
let _e8745 = (_e8741 + _e8744);
let _e8746 = -(_e8745);
let _e8749 = (_e8728 - select(_e8746, _e8745, (_e8745 > _e8746)));
let _e8751 = select(0f, _e8749, (_e8749 > 0f));
let _e8753 = select(_e8726, _e8751, (_e8751 < _e8726));
let _e8756 = (_e8749 - _e8726);
let _e8760 = (((_e8753 * (_e8753 * _e8729)) + select(0f, _e8756, (_e8756 > 0f))) * _e8730);
let _e8764 = (_e8741 - _e8744);
let _e8765 = -(_e8764);
let _e8768 = (_e8728 - select(_e8765, _e8764, (_e8764 > _e8765)));
let _e8770 = select(0f, _e8768, (_e8768 > 0f));
let _e8772 = select(_e8726, _e8770, (_e8770 < _e8726));
let _e8775 = (_e8768 - _e8726);
let _e8779 = (((_e8772 * (_e8772 * _e8729)) + select(0f, _e8775, (_e8775 > 0f))) * _e8730);
if _e326 {
phi_19800_ = type_23(_e8734, _e8641);
} else {
phi_19800_ = type_23(_e8641, _e8734);
}
let _e8788 = phi_19800_;
let _e8794 = ((_e8788.member_1 * _e803) + _e8788.member);
let _e8796 = (bitcast<i32>(_e138) - 1i);
let _e8798 = select(_e8796, _e8794, (_e8794 < _e8796));
let _e8803 = global_4.member[bitcast<u32>(select(0i, _e8798, (_e8798 > 0i)))];
let _e8804 = (bitcast<i32>((_e799 * _e802)) + _e8794);
let _e8806 = select(_e8796, _e8804, (_e8804 < _e8796));
let _e8811 = global_4.member[bitcast<u32>(select(0i, _e8806, (_e8806 > 0i)))];
let _e8814 = f32(_e803);
let _e8815 = f32(_e804);
let _e8822 = global_1.member.member_2.member;
let _e8823 = (((((f32(_e8788.member) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e8830 = global_1.member.member_2.member_1;
let _e8831 = ((1f - (((f32(_e8788.member_1) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e8833 = global_1.member.member_3;
let _e8841 = global_1.member.member_4;
let _e8848 = ((_e8833.member * _e8823) + (_e8841.member * _e8831));
let _e8849 = ((_e8833.member_1 * _e8823) + (_e8841.member_1 * _e8831));
let _e8850 = ((_e8833.member_2 * _e8823) + (_e8841.member_2 * _e8831));
let _e8853 = global_1.member.member_2.member_3;
let _e8854 = (_e8853 != 0u);
let _e8856 = global_1.member.member_5;
let _e8863 = select((_e8856.member + _e8848), _e8856.member, _e8854);
let _e8864 = select((_e8856.member_1 + _e8849), _e8856.member_1, _e8854);
let _e8865 = select((_e8856.member_2 + _e8850), _e8856.member_2, _e8854);
let _e8867 = global_1.member.member_6;
let _e8881 = (((_e8863 * _e8863) + (_e8864 * _e8864)) + (_e8865 * _e8865));
let _e8884 = sqrt(select(0f, _e8881, (_e8881 > 0f)));
let _e8885 = (1f / _e8884);
let _e8886 = (_e8863 * _e8885);
let _e8887 = (_e8864 * _e8885);
let _e8888 = (_e8865 * _e8885);
let _e8889 = (_e444 - select(_e8867.member, (_e8867.member + _e8848), _e8854));
let _e8890 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e8849), _e8854));
let _e8891 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e8850), _e8854));
let _e8896 = (((_e8889 * _e8886) + (_e8890 * _e8887)) + (_e8891 * _e8888));
let _e8901 = (((_e8889 * _e482) + (_e8890 * _e495)) + (_e8891 * _e508));
let _e8906 = (((_e8886 * _e482) + (_e8887 * _e495)) + (_e8888 * _e508));
let _e8909 = ((_e8887 * _e508) - (_e8888 * _e495));
let _e8912 = ((_e8888 * _e482) - (_e8886 * _e508));
let _e8915 = ((_e8886 * _e495) - (_e8887 * _e482));
let _e8920 = (((_e8909 * _e8909) + (_e8912 * _e8912)) + (_e8915 * _e8915));
let _e8923 = (1f / select(1e-9f, _e8920, (_e8920 > 1e-9f)));
let _e8926 = ((_e8896 - (_e8906 * _e8901)) * _e8923);
let _e8929 = (((_e8906 * _e8896) - _e8901) * _e8923);
let _e8935 = (_e8926 - _e8811);
let _e8938 = (_e8929 + select(0f, _e8935, (_e8935 > 0f)));
let _e8941 = global_1.member.member_13.member;
let _e8946 = -((_e8941.member * _e8938));
let _e8948 = select(-87f, _e8946, (_e8946 > -87f));
let _e8950 = select(88f, _e8948, (_e8948 < 88f));
let _e8952 = ((_e8950 * 1.442695f) + 0.5f);
let _e8954 = select(-127f, _e8952, (_e8952 > -127f));
let _e8956 = select(128f, _e8954, (_e8954 < 128f));
let _e8963 = select(0i, select(select(i32(_e8956), i32(-2147483648), (_e8956 < -2147483600f)), 2147483647i, (_e8956 > 2147483500f)), (_e8956 == _e8956));
let _e8967 = (_e8963 - select(0i, 1i, (_e8956 < f32(_e8963))));
let _e8968 = f32(_e8967);
let _e8972 = ((_e8950 - (_e8968 * 0.6933594f)) - (_e8968 * -2.1219444e-4f));
let _e8994 = -((_e8941.member_1 * _e8938));
let _e8996 = select(-87f, _e8994, (_e8994 > -87f));
let _e8998 = select(88f, _e8996, (_e8996 < 88f));
let _e9000 = ((_e8998 * 1.442695f) + 0.5f);
let _e9002 = select(-127f, _e9000, (_e9000 > -127f));
let _e9004 = select(128f, _e9002, (_e9002 < 128f));
let _e9011 = select(0i, select(select(i32(_e9004), i32(-2147483648), (_e9004 < -2147483600f)), 2147483647i, (_e9004 > 2147483500f)), (_e9004 == _e9004));
let _e9015 = (_e9011 - select(0i, 1i, (_e9004 < f32(_e9011))));
let _e9016 = f32(_e9015);
let _e9020 = ((_e8998 - (_e9016 * 0.6933594f)) - (_e9016 * -2.1219444e-4f));
let _e9042 = -((_e8941.member_2 * _e8938));
let _e9044 = select(-87f, _e9042, (_e9042 > -87f));
let _e9046 = select(88f, _e9044, (_e9044 < 88f));
let _e9048 = ((_e9046 * 1.442695f) + 0.5f);
let _e9050 = select(-127f, _e9048, (_e9048 > -127f));
let _e9052 = select(128f, _e9050, (_e9050 < 128f));
let _e9059 = select(0i, select(select(i32(_e9052), i32(-2147483648), (_e9052 < -2147483600f)), 2147483647i, (_e9052 > 2147483500f)), (_e9052 == _e9052));
let _e9063 = (_e9059 - select(0i, 1i, (_e9052 < f32(_e9059))));
let _e9064 = f32(_e9063);
let _e9068 = ((_e9046 - (_e9064 * 0.6933594f)) - (_e9064 * -2.1219444e-4f));
let _e9089 = -(_e8906);
let _e9092 = global_1.member.member_13.member_2;
let _e9093 = (_e9092 * _e9092);
let _e9097 = ((1f + _e9093) - ((2f * _e9092) * _e9089));
let _e9099 = select(1e-9f, _e9097, (_e9097 > 1e-9f));
let _e9111 = global_1.member.member_13.member_3;
let _e9116 = (_e8884 * (select(((1f - _e9093) / (_e9099 * sqrt(select(0f, _e9099, (_e9099 > 0f))))), (0.75f * (1f + (_e9089 * _e9089))), (_e9111 == 1u)) * (0.25f / 3.1415927f)));
let _e9119 = global_1.member.member_13.member_1;
let _e9132 = select(0f, _e8926, (((_e8929 >= 0f) && (_e8929 < _e560)) && (_e8926 > 0f)));
if _e326 {
phi_20344_ = type_23(_e5688, _e5687);
} else {
phi_20344_ = type_23(_e5687, _e5688);
}
let _e9136 = phi_20344_;
let _e9141 = f32((1i << bitcast<u32>(_e5676)));
let _e9142 = (1f / _e9141);
let _e9144 = ((_e8643 * _e9142) - 0.5f);
let _e9146 = ((_e8737 * _e9142) - 0.5f);
let _e9148 = select(-1f, _e9144, (_e9144 > -1f));
let _e9150 = select(1e6f, _e9148, (_e9148 < 1e6f));
let _e9157 = select(0i, select(select(i32(_e9150), i32(-2147483648), (_e9150 < -2147483600f)), 2147483647i, (_e9150 > 2147483500f)), (_e9150 == _e9150));
let _e9161 = (_e9157 - select(0i, 1i, (_e9150 < f32(_e9157))));
let _e9163 = select(-1f, _e9146, (_e9146 > -1f));
let _e9165 = select(1e6f, _e9163, (_e9163 < 1e6f));
let _e9172 = select(0i, select(select(i32(_e9165), i32(-2147483648), (_e9165 < -2147483600f)), 2147483647i, (_e9165 > 2147483500f)), (_e9165 == _e9165));
let _e9176 = (_e9172 - select(0i, 1i, (_e9165 < f32(_e9172))));
let _e9178 = (_e9144 - f32(_e9161));
let _e9180 = (_e9146 - f32(_e9176));
let _e9181 = (1f - _e9178);
let _e9182 = (1f - _e9180);
let _e9185 = select(_e9161, 0i, (_e9161 < 0i));
let _e9186 = (_e9185 >= _e9136.member);
if _e9186 {
phi_20422_ = (_e9136.member - 1i);
} else {
phi_20422_ = _e9185;
}
let _e9189 = phi_20422_;
let _e9191 = select(_e9176, 0i, (_e9176 < 0i));
let _e9192 = (_e9191 >= _e9136.member_1);
if _e9192 {
phi_20433_ = (_e9136.member_1 - 1i);
} else {
phi_20433_ = _e9191;
}
let _e9195 = phi_20433_;
let _e9199 = (((f32(_e9189) + 0.5f) * _e9141) - 0.5f);
let _e9203 = (((f32(_e9195) + 0.5f) * _e9141) - 0.5f);
if _e326 {
phi_20461_ = type_23(_e9195, _e9189);
} else {
phi_20461_ = type_23(_e9189, _e9195);
}
let _e9209 = phi_20461_;
let _e9215 = bitcast<i32>(((_e799 + 1u) >> bitcast<u32>(1u)));
let _e9218 = global_1.member.member_18.member_6;
let _e9221 = global_1.member.member_18.member_7;
let _e9224 = global_1.member.member_18.member_8;
if _e854 {
phi_20512_ = 0u;
} else {
if (_e635 == 1u) {
phi_20511_ = 0u;
} else {
if (_e635 == 2u) {
phi_20510_ = _e9218;
} else {
phi_20510_ = select(_e9224, _e9221, (_e635 == 3u));
}
let _e9230 = phi_20510_;
phi_20511_ = _e9230;
}
let _e9232 = phi_20511_;
phi_20512_ = _e9232;
}
let _e9234 = phi_20512_;
local_22 = (((bitcast<i32>(_e9234) + _e9209.member_1) * _e9215) + _e9209.member);
let _e9239 = local_22;
let _e9241 = (bitcast<i32>(_e141) - 1i);
let _e9243 = select(_e9241, _e9239, (_e9239 < _e9241));
let _e9248 = global_5.member[bitcast<u32>(select(0i, _e9243, (_e9243 > 0i)))];
let _e9253 = (((((select(_e9199, _e9203, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e9258 = ((1f - (((select(_e9203, _e9199, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e9265 = ((_e8833.member * _e9253) + (_e8841.member * _e9258));
let _e9266 = ((_e8833.member_1 * _e9253) + (_e8841.member_1 * _e9258));
let _e9267 = ((_e8833.member_2 * _e9253) + (_e8841.member_2 * _e9258));
let _e9271 = select((_e8856.member + _e9265), _e8856.member, _e8854);
let _e9272 = select((_e8856.member_1 + _e9266), _e8856.member_1, _e8854);
let _e9273 = select((_e8856.member_2 + _e9267), _e8856.member_2, _e8854);
let _e9284 = (((_e9271 * _e9271) + (_e9272 * _e9272)) + (_e9273 * _e9273));
let _e9288 = (1f / sqrt(select(0f, _e9284, (_e9284 > 0f))));
let _e9289 = (_e9271 * _e9288);
let _e9290 = (_e9272 * _e9288);
let _e9291 = (_e9273 * _e9288);
let _e9292 = (_e444 - select(_e8867.member, (_e8867.member + _e9265), _e8854));
let _e9293 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e9266), _e8854));
let _e9294 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e9267), _e8854));
let _e9299 = (((_e9292 * _e9289) + (_e9293 * _e9290)) + (_e9294 * _e9291));
let _e9304 = (((_e9292 * _e482) + (_e9293 * _e495)) + (_e9294 * _e508));
let _e9309 = (((_e9289 * _e482) + (_e9290 * _e495)) + (_e9291 * _e508));
let _e9312 = ((_e9290 * _e508) - (_e9291 * _e495));
let _e9315 = ((_e9291 * _e482) - (_e9289 * _e508));
let _e9318 = ((_e9289 * _e495) - (_e9290 * _e482));
let _e9323 = (((_e9312 * _e9312) + (_e9315 * _e9315)) + (_e9318 * _e9318));
let _e9326 = (1f / select(1e-9f, _e9323, (_e9323 > 1e-9f)));
let _e9329 = ((_e9299 - (_e9309 * _e9304)) * _e9326);
let _e9332 = (((_e9309 * _e9299) - _e9304) * _e9326);
let _e9338 = select(0f, _e9329, (((_e9332 >= 0f) && (_e9332 < _e560)) && (_e9329 > 0f)));
let _e9340 = (_e9189 << bitcast<u32>(_e5676));
let _e9352 = (_e9161 + 1i);
let _e9355 = select(_e9352, 0i, (_e9352 < 0i));
let _e9356 = (_e9355 >= _e9136.member);
if _e9356 {
phi_20929_ = (_e9136.member - 1i);
} else {
phi_20929_ = _e9355;
}
let _e9359 = phi_20929_;
if _e9192 {
phi_20940_ = (_e9136.member_1 - 1i);
} else {
phi_20940_ = _e9191;
}
let _e9362 = phi_20940_;
let _e9366 = (((f32(_e9359) + 0.5f) * _e9141) - 0.5f);
let _e9370 = (((f32(_e9362) + 0.5f) * _e9141) - 0.5f);
if _e326 {
phi_20968_ = type_23(_e9362, _e9359);
} else {
phi_20968_ = type_23(_e9359, _e9362);
}
let _e9376 = phi_20968_;
if _e854 {
phi_21019_ = 0u;
} else {
if (_e635 == 1u) {
phi_21018_ = 0u;
} else {
if (_e635 == 2u) {
phi_21017_ = _e9218;
} else {
phi_21017_ = select(_e9224, _e9221, (_e635 == 3u));
}
let _e9384 = phi_21017_;
phi_21018_ = _e9384;
}
let _e9386 = phi_21018_;
phi_21019_ = _e9386;
}
let _e9388 = phi_21019_;
local_20 = (((bitcast<i32>(_e9388) + _e9376.member_1) * _e9215) + _e9376.member);
let _e9393 = local_20;
let _e9395 = select(_e9241, _e9393, (_e9393 < _e9241));
let _e9400 = global_5.member[bitcast<u32>(select(0i, _e9395, (_e9395 > 0i)))];
let _e9405 = (((((select(_e9366, _e9370, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e9410 = ((1f - (((select(_e9370, _e9366, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e9417 = ((_e8833.member * _e9405) + (_e8841.member * _e9410));
let _e9418 = ((_e8833.member_1 * _e9405) + (_e8841.member_1 * _e9410));
let _e9419 = ((_e8833.member_2 * _e9405) + (_e8841.member_2 * _e9410));
let _e9423 = select((_e8856.member + _e9417), _e8856.member, _e8854);
let _e9424 = select((_e8856.member_1 + _e9418), _e8856.member_1, _e8854);
let _e9425 = select((_e8856.member_2 + _e9419), _e8856.member_2, _e8854);
let _e9436 = (((_e9423 * _e9423) + (_e9424 * _e9424)) + (_e9425 * _e9425));
let _e9440 = (1f / sqrt(select(0f, _e9436, (_e9436 > 0f))));
let _e9441 = (_e9423 * _e9440);
let _e9442 = (_e9424 * _e9440);
let _e9443 = (_e9425 * _e9440);
let _e9444 = (_e444 - select(_e8867.member, (_e8867.member + _e9417), _e8854));
let _e9445 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e9418), _e8854));
let _e9446 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e9419), _e8854));
let _e9451 = (((_e9444 * _e9441) + (_e9445 * _e9442)) + (_e9446 * _e9443));
let _e9456 = (((_e9444 * _e482) + (_e9445 * _e495)) + (_e9446 * _e508));
let _e9461 = (((_e9441 * _e482) + (_e9442 * _e495)) + (_e9443 * _e508));
let _e9464 = ((_e9442 * _e508) - (_e9443 * _e495));
let _e9467 = ((_e9443 * _e482) - (_e9441 * _e508));
let _e9470 = ((_e9441 * _e495) - (_e9442 * _e482));
let _e9475 = (((_e9464 * _e9464) + (_e9467 * _e9467)) + (_e9470 * _e9470));
let _e9478 = (1f / select(1e-9f, _e9475, (_e9475 > 1e-9f)));
let _e9481 = ((_e9451 - (_e9461 * _e9456)) * _e9478);
let _e9484 = (((_e9461 * _e9451) - _e9456) * _e9478);
let _e9490 = select(0f, _e9481, (((_e9484 >= 0f) && (_e9484 < _e560)) && (_e9481 > 0f)));
let _e9492 = (_e9359 << bitcast<u32>(_e5676));
let _e9504 = (_e9176 + 1i);
if _e9186 {
phi_21436_ = (_e9136.member - 1i);
} else {
phi_21436_ = _e9185;
}
let _e9508 = phi_21436_;
let _e9510 = select(_e9504, 0i, (_e9504 < 0i));
let _e9511 = (_e9510 >= _e9136.member_1);
if _e9511 {
phi_21447_ = (_e9136.member_1 - 1i);
} else {
phi_21447_ = _e9510;
}
let _e9514 = phi_21447_;
let _e9518 = (((f32(_e9508) + 0.5f) * _e9141) - 0.5f);
let _e9522 = (((f32(_e9514) + 0.5f) * _e9141) - 0.5f);
if _e326 {
phi_21475_ = type_23(_e9514, _e9508);
} else {
phi_21475_ = type_23(_e9508, _e9514);
}
let _e9528 = phi_21475_;
if _e854 {
phi_21526_ = 0u;
} else {
if (_e635 == 1u) {
phi_21525_ = 0u;
} else {
if (_e635 == 2u) {
phi_21524_ = _e9218;
} else {
phi_21524_ = select(_e9224, _e9221, (_e635 == 3u));
}
let _e9536 = phi_21524_;
phi_21525_ = _e9536;
}
let _e9538 = phi_21525_;
phi_21526_ = _e9538;
}
let _e9540 = phi_21526_;
local_18 = (((bitcast<i32>(_e9540) + _e9528.member_1) * _e9215) + _e9528.member);
let _e9545 = local_18;
let _e9547 = select(_e9241, _e9545, (_e9545 < _e9241));
let _e9552 = global_5.member[bitcast<u32>(select(0i, _e9547, (_e9547 > 0i)))];
let _e9557 = (((((select(_e9518, _e9522, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e9562 = ((1f - (((select(_e9522, _e9518, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e9569 = ((_e8833.member * _e9557) + (_e8841.member * _e9562));
let _e9570 = ((_e8833.member_1 * _e9557) + (_e8841.member_1 * _e9562));
let _e9571 = ((_e8833.member_2 * _e9557) + (_e8841.member_2 * _e9562));
let _e9575 = select((_e8856.member + _e9569), _e8856.member, _e8854);
let _e9576 = select((_e8856.member_1 + _e9570), _e8856.member_1, _e8854);
let _e9577 = select((_e8856.member_2 + _e9571), _e8856.member_2, _e8854);
let _e9588 = (((_e9575 * _e9575) + (_e9576 * _e9576)) + (_e9577 * _e9577));
let _e9592 = (1f / sqrt(select(0f, _e9588, (_e9588 > 0f))));
let _e9593 = (_e9575 * _e9592);
let _e9594 = (_e9576 * _e9592);
let _e9595 = (_e9577 * _e9592);
let _e9596 = (_e444 - select(_e8867.member, (_e8867.member + _e9569), _e8854));
let _e9597 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e9570), _e8854));
let _e9598 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e9571), _e8854));
let _e9603 = (((_e9596 * _e9593) + (_e9597 * _e9594)) + (_e9598 * _e9595));
let _e9608 = (((_e9596 * _e482) + (_e9597 * _e495)) + (_e9598 * _e508));
let _e9613 = (((_e9593 * _e482) + (_e9594 * _e495)) + (_e9595 * _e508));
let _e9616 = ((_e9594 * _e508) - (_e9595 * _e495));
let _e9619 = ((_e9595 * _e482) - (_e9593 * _e508));
let _e9622 = ((_e9593 * _e495) - (_e9594 * _e482));
let _e9627 = (((_e9616 * _e9616) + (_e9619 * _e9619)) + (_e9622 * _e9622));
let _e9630 = (1f / select(1e-9f, _e9627, (_e9627 > 1e-9f)));
let _e9633 = ((_e9603 - (_e9613 * _e9608)) * _e9630);
let _e9636 = (((_e9613 * _e9603) - _e9608) * _e9630);
let _e9642 = select(0f, _e9633, (((_e9636 >= 0f) && (_e9636 < _e560)) && (_e9633 > 0f)));
let _e9644 = (_e9508 << bitcast<u32>(_e5676));
if _e9356 {
phi_21943_ = (_e9136.member - 1i);
} else {
phi_21943_ = _e9355;
}
let _e9659 = phi_21943_;
if _e9511 {
phi_21954_ = (_e9136.member_1 - 1i);
} else {
phi_21954_ = _e9510;
}
let _e9662 = phi_21954_;
let _e9666 = (((f32(_e9659) + 0.5f) * _e9141) - 0.5f);
let _e9670 = (((f32(_e9662) + 0.5f) * _e9141) - 0.5f);
if _e326 {
phi_21982_ = type_23(_e9662, _e9659);
} else {
phi_21982_ = type_23(_e9659, _e9662);
}
let _e9676 = phi_21982_;
if _e854 {
phi_22033_ = 0u;
} else {
if (_e635 == 1u) {
phi_22032_ = 0u;
} else {
if (_e635 == 2u) {
phi_22031_ = _e9218;
} else {
phi_22031_ = select(_e9224, _e9221, (_e635 == 3u));
}
let _e9684 = phi_22031_;
phi_22032_ = _e9684;
}
let _e9686 = phi_22032_;
phi_22033_ = _e9686;
}
let _e9688 = phi_22033_;
local_16 = (((bitcast<i32>(_e9688) + _e9676.member_1) * _e9215) + _e9676.member);
let _e9693 = local_16;
let _e9695 = select(_e9241, _e9693, (_e9693 < _e9241));
let _e9700 = global_5.member[bitcast<u32>(select(0i, _e9695, (_e9695 > 0i)))];
let _e9705 = (((((select(_e9666, _e9670, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e9710 = ((1f - (((select(_e9670, _e9666, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e9717 = ((_e8833.member * _e9705) + (_e8841.member * _e9710));
let _e9718 = ((_e8833.member_1 * _e9705) + (_e8841.member_1 * _e9710));
let _e9719 = ((_e8833.member_2 * _e9705) + (_e8841.member_2 * _e9710));
let _e9723 = select((_e8856.member + _e9717), _e8856.member, _e8854);
let _e9724 = select((_e8856.member_1 + _e9718), _e8856.member_1, _e8854);
let _e9725 = select((_e8856.member_2 + _e9719), _e8856.member_2, _e8854);
let _e9736 = (((_e9723 * _e9723) + (_e9724 * _e9724)) + (_e9725 * _e9725));
let _e9740 = (1f / sqrt(select(0f, _e9736, (_e9736 > 0f))));
let _e9741 = (_e9723 * _e9740);
let _e9742 = (_e9724 * _e9740);
let _e9743 = (_e9725 * _e9740);
let _e9744 = (_e444 - select(_e8867.member, (_e8867.member + _e9717), _e8854));
let _e9745 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e9718), _e8854));
let _e9746 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e9719), _e8854));
let _e9751 = (((_e9744 * _e9741) + (_e9745 * _e9742)) + (_e9746 * _e9743));
let _e9756 = (((_e9744 * _e482) + (_e9745 * _e495)) + (_e9746 * _e508));
let _e9761 = (((_e9741 * _e482) + (_e9742 * _e495)) + (_e9743 * _e508));
let _e9764 = ((_e9742 * _e508) - (_e9743 * _e495));
let _e9767 = ((_e9743 * _e482) - (_e9741 * _e508));
let _e9770 = ((_e9741 * _e495) - (_e9742 * _e482));
let _e9775 = (((_e9764 * _e9764) + (_e9767 * _e9767)) + (_e9770 * _e9770));
let _e9778 = (1f / select(1e-9f, _e9775, (_e9775 > 1e-9f)));
let _e9781 = ((_e9751 - (_e9761 * _e9756)) * _e9778);
let _e9784 = (((_e9761 * _e9751) - _e9756) * _e9778);
let _e9790 = select(0f, _e9781, (((_e9784 >= 0f) && (_e9784 < _e560)) && (_e9781 > 0f)));
let _e9792 = (_e9659 << bitcast<u32>(_e5676));
let _e9804 = select(((((1f - select(0f, (_e9181 * _e9182), (((select(select(_e635, _e796, (_e9340 >= _e561)), _e716, (_e9340 < _e171)) == _e635) && (_e9338 > 0f)) && (_e9338 < _e9248)))) - select(0f, (_e9178 * _e9182), (((select(select(_e635, _e796, (_e9492 >= _e561)), _e716, (_e9492 < _e171)) == _e635) && (_e9490 > 0f)) && (_e9490 < _e9400)))) - select(0f, (_e9181 * _e9180), (((select(select(_e635, _e796, (_e9644 >= _e561)), _e716, (_e9644 < _e171)) == _e635) && (_e9642 > 0f)) && (_e9642 < _e9552)))) - select(0f, (_e9178 * _e9180), (((select(select(_e635, _e796, (_e9792 >= _e561)), _e716, (_e9792 < _e171)) == _e635) && (_e9790 > 0f)) && (_e9790 < _e9700)))), 1f, _e854);
let _e9805 = (_e6540 & 31u);
let _e9807 = (1u << bitcast<u32>(_e9805));
let _e9816 = bitcast<i32>((((_e799 + _e9807) - 1u) >> bitcast<u32>(_e9805)));
let _e9817 = bitcast<i32>((((_e802 + _e9807) - 1u) >> bitcast<u32>(_e9805)));
if _e326 {
phi_22468_ = type_23(_e9817, _e9816);
} else {
phi_22468_ = type_23(_e9816, _e9817);
}
let _e9821 = phi_22468_;
let _e9826 = f32((1i << bitcast<u32>(_e9805)));
let _e9827 = (1f / _e9826);
let _e9829 = ((_e8643 * _e9827) - 0.5f);
let _e9831 = ((_e8737 * _e9827) - 0.5f);
let _e9833 = select(-1f, _e9829, (_e9829 > -1f));
let _e9835 = select(1e6f, _e9833, (_e9833 < 1e6f));
let _e9842 = select(0i, select(select(i32(_e9835), i32(-2147483648), (_e9835 < -2147483600f)), 2147483647i, (_e9835 > 2147483500f)), (_e9835 == _e9835));
let _e9846 = (_e9842 - select(0i, 1i, (_e9835 < f32(_e9842))));
let _e9848 = select(-1f, _e9831, (_e9831 > -1f));
let _e9850 = select(1e6f, _e9848, (_e9848 < 1e6f));
let _e9857 = select(0i, select(select(i32(_e9850), i32(-2147483648), (_e9850 < -2147483600f)), 2147483647i, (_e9850 > 2147483500f)), (_e9850 == _e9850));
let _e9861 = (_e9857 - select(0i, 1i, (_e9850 < f32(_e9857))));
let _e9863 = (_e9829 - f32(_e9846));
let _e9865 = (_e9831 - f32(_e9861));
let _e9866 = (1f - _e9863);
let _e9867 = (1f - _e9865);
let _e9870 = select(_e9846, 0i, (_e9846 < 0i));
let _e9871 = (_e9870 >= _e9821.member);
if _e9871 {
phi_22546_ = (_e9821.member - 1i);
} else {
phi_22546_ = _e9870;
}
let _e9874 = phi_22546_;
let _e9876 = select(_e9861, 0i, (_e9861 < 0i));
let _e9877 = (_e9876 >= _e9821.member_1);
if _e9877 {
phi_22557_ = (_e9821.member_1 - 1i);
} else {
phi_22557_ = _e9876;
}
let _e9880 = phi_22557_;
let _e9884 = (((f32(_e9874) + 0.5f) * _e9826) - 0.5f);
let _e9888 = (((f32(_e9880) + 0.5f) * _e9826) - 0.5f);
if _e326 {
phi_22585_ = type_23(_e9880, _e9874);
} else {
phi_22585_ = type_23(_e9874, _e9880);
}
let _e9894 = phi_22585_;
let _e9897 = (_e6540 == 0u);
if _e9897 {
phi_22636_ = 0u;
} else {
if (_e6540 == 1u) {
phi_22635_ = 0u;
} else {
if (_e6540 == 2u) {
phi_22634_ = _e9218;
} else {
phi_22634_ = select(_e9224, _e9221, (_e6540 == 3u));
}
let _e9903 = phi_22634_;
phi_22635_ = _e9903;
}
let _e9905 = phi_22635_;
phi_22636_ = _e9905;
}
let _e9907 = phi_22636_;
local_14 = (((bitcast<i32>(_e9907) + _e9894.member_1) * _e9215) + _e9894.member);
let _e9912 = local_14;
let _e9914 = select(_e9241, _e9912, (_e9912 < _e9241));
let _e9919 = global_5.member[bitcast<u32>(select(0i, _e9914, (_e9914 > 0i)))];
let _e9924 = (((((select(_e9884, _e9888, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e9929 = ((1f - (((select(_e9888, _e9884, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e9936 = ((_e8833.member * _e9924) + (_e8841.member * _e9929));
let _e9937 = ((_e8833.member_1 * _e9924) + (_e8841.member_1 * _e9929));
let _e9938 = ((_e8833.member_2 * _e9924) + (_e8841.member_2 * _e9929));
let _e9942 = select((_e8856.member + _e9936), _e8856.member, _e8854);
let _e9943 = select((_e8856.member_1 + _e9937), _e8856.member_1, _e8854);
let _e9944 = select((_e8856.member_2 + _e9938), _e8856.member_2, _e8854);
let _e9955 = (((_e9942 * _e9942) + (_e9943 * _e9943)) + (_e9944 * _e9944));
let _e9959 = (1f / sqrt(select(0f, _e9955, (_e9955 > 0f))));
let _e9960 = (_e9942 * _e9959);
let _e9961 = (_e9943 * _e9959);
let _e9962 = (_e9944 * _e9959);
let _e9963 = (_e444 - select(_e8867.member, (_e8867.member + _e9936), _e8854));
let _e9964 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e9937), _e8854));
let _e9965 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e9938), _e8854));
let _e9970 = (((_e9963 * _e9960) + (_e9964 * _e9961)) + (_e9965 * _e9962));
let _e9975 = (((_e9963 * _e482) + (_e9964 * _e495)) + (_e9965 * _e508));
let _e9980 = (((_e9960 * _e482) + (_e9961 * _e495)) + (_e9962 * _e508));
let _e9983 = ((_e9961 * _e508) - (_e9962 * _e495));
let _e9986 = ((_e9962 * _e482) - (_e9960 * _e508));
let _e9989 = ((_e9960 * _e495) - (_e9961 * _e482));
let _e9994 = (((_e9983 * _e9983) + (_e9986 * _e9986)) + (_e9989 * _e9989));
let _e9997 = (1f / select(1e-9f, _e9994, (_e9994 > 1e-9f)));
let _e10000 = ((_e9970 - (_e9980 * _e9975)) * _e9997);
let _e10003 = (((_e9980 * _e9970) - _e9975) * _e9997);
let _e10009 = select(0f, _e10000, (((_e10003 >= 0f) && (_e10003 < _e560)) && (_e10000 > 0f)));
let _e10011 = (_e9874 << bitcast<u32>(_e9805));
let _e10023 = (_e9846 + 1i);
let _e10026 = select(_e10023, 0i, (_e10023 < 0i));
let _e10027 = (_e10026 >= _e9821.member);
if _e10027 {
phi_23053_ = (_e9821.member - 1i);
} else {
phi_23053_ = _e10026;
}
let _e10030 = phi_23053_;
if _e9877 {
phi_23064_ = (_e9821.member_1 - 1i);
} else {
phi_23064_ = _e9876;
}
let _e10033 = phi_23064_;
let _e10037 = (((f32(_e10030) + 0.5f) * _e9826) - 0.5f);
let _e10041 = (((f32(_e10033) + 0.5f) * _e9826) - 0.5f);
if _e326 {
phi_23092_ = type_23(_e10033, _e10030);
} else {
phi_23092_ = type_23(_e10030, _e10033);
}
let _e10047 = phi_23092_;
if _e9897 {
phi_23143_ = 0u;
} else {
if (_e6540 == 1u) {
phi_23142_ = 0u;
} else {
if (_e6540 == 2u) {
phi_23141_ = _e9218;
} else {
phi_23141_ = select(_e9224, _e9221, (_e6540 == 3u));
}
let _e10055 = phi_23141_;
phi_23142_ = _e10055;
}
let _e10057 = phi_23142_;
phi_23143_ = _e10057;
}
let _e10059 = phi_23143_;
local_12 = (((bitcast<i32>(_e10059) + _e10047.member_1) * _e9215) + _e10047.member);
let _e10064 = local_12;
let _e10066 = select(_e9241, _e10064, (_e10064 < _e9241));
let _e10071 = global_5.member[bitcast<u32>(select(0i, _e10066, (_e10066 > 0i)))];
let _e10076 = (((((select(_e10037, _e10041, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e10081 = ((1f - (((select(_e10041, _e10037, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e10088 = ((_e8833.member * _e10076) + (_e8841.member * _e10081));
let _e10089 = ((_e8833.member_1 * _e10076) + (_e8841.member_1 * _e10081));
let _e10090 = ((_e8833.member_2 * _e10076) + (_e8841.member_2 * _e10081));
let _e10094 = select((_e8856.member + _e10088), _e8856.member, _e8854);
let _e10095 = select((_e8856.member_1 + _e10089), _e8856.member_1, _e8854);
let _e10096 = select((_e8856.member_2 + _e10090), _e8856.member_2, _e8854);
let _e10107 = (((_e10094 * _e10094) + (_e10095 * _e10095)) + (_e10096 * _e10096));
let _e10111 = (1f / sqrt(select(0f, _e10107, (_e10107 > 0f))));
let _e10112 = (_e10094 * _e10111);
let _e10113 = (_e10095 * _e10111);
let _e10114 = (_e10096 * _e10111);
let _e10115 = (_e444 - select(_e8867.member, (_e8867.member + _e10088), _e8854));
let _e10116 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e10089), _e8854));
let _e10117 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e10090), _e8854));
let _e10122 = (((_e10115 * _e10112) + (_e10116 * _e10113)) + (_e10117 * _e10114));
let _e10127 = (((_e10115 * _e482) + (_e10116 * _e495)) + (_e10117 * _e508));
let _e10132 = (((_e10112 * _e482) + (_e10113 * _e495)) + (_e10114 * _e508));
let _e10135 = ((_e10113 * _e508) - (_e10114 * _e495));
let _e10138 = ((_e10114 * _e482) - (_e10112 * _e508));
let _e10141 = ((_e10112 * _e495) - (_e10113 * _e482));
let _e10146 = (((_e10135 * _e10135) + (_e10138 * _e10138)) + (_e10141 * _e10141));
let _e10149 = (1f / select(1e-9f, _e10146, (_e10146 > 1e-9f)));
let _e10152 = ((_e10122 - (_e10132 * _e10127)) * _e10149);
let _e10155 = (((_e10132 * _e10122) - _e10127) * _e10149);
let _e10161 = select(0f, _e10152, (((_e10155 >= 0f) && (_e10155 < _e560)) && (_e10152 > 0f)));
let _e10163 = (_e10030 << bitcast<u32>(_e9805));
let _e10175 = (_e9861 + 1i);
if _e9871 {
phi_23560_ = (_e9821.member - 1i);
} else {
phi_23560_ = _e9870;
}
let _e10179 = phi_23560_;
let _e10181 = select(_e10175, 0i, (_e10175 < 0i));
let _e10182 = (_e10181 >= _e9821.member_1);
if _e10182 {
phi_23571_ = (_e9821.member_1 - 1i);
} else {
phi_23571_ = _e10181;
}
let _e10185 = phi_23571_;
let _e10189 = (((f32(_e10179) + 0.5f) * _e9826) - 0.5f);
let _e10193 = (((f32(_e10185) + 0.5f) * _e9826) - 0.5f);
if _e326 {
phi_23599_ = type_23(_e10185, _e10179);
} else {
phi_23599_ = type_23(_e10179, _e10185);
}
let _e10199 = phi_23599_;
if _e9897 {
phi_23650_ = 0u;
} else {
if (_e6540 == 1u) {
phi_23649_ = 0u;
} else {
if (_e6540 == 2u) {
phi_23648_ = _e9218;
} else {
phi_23648_ = select(_e9224, _e9221, (_e6540 == 3u));
}
let _e10207 = phi_23648_;
phi_23649_ = _e10207;
}
let _e10209 = phi_23649_;
phi_23650_ = _e10209;
}
let _e10211 = phi_23650_;
local_10 = (((bitcast<i32>(_e10211) + _e10199.member_1) * _e9215) + _e10199.member);
let _e10216 = local_10;
let _e10218 = select(_e9241, _e10216, (_e10216 < _e9241));
let _e10223 = global_5.member[bitcast<u32>(select(0i, _e10218, (_e10218 > 0i)))];
let _e10228 = (((((select(_e10189, _e10193, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e10233 = ((1f - (((select(_e10193, _e10189, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e10240 = ((_e8833.member * _e10228) + (_e8841.member * _e10233));
let _e10241 = ((_e8833.member_1 * _e10228) + (_e8841.member_1 * _e10233));
let _e10242 = ((_e8833.member_2 * _e10228) + (_e8841.member_2 * _e10233));
let _e10246 = select((_e8856.member + _e10240), _e8856.member, _e8854);
let _e10247 = select((_e8856.member_1 + _e10241), _e8856.member_1, _e8854);
let _e10248 = select((_e8856.member_2 + _e10242), _e8856.member_2, _e8854);
let _e10259 = (((_e10246 * _e10246) + (_e10247 * _e10247)) + (_e10248 * _e10248));
let _e10263 = (1f / sqrt(select(0f, _e10259, (_e10259 > 0f))));
let _e10264 = (_e10246 * _e10263);
let _e10265 = (_e10247 * _e10263);
let _e10266 = (_e10248 * _e10263);
let _e10267 = (_e444 - select(_e8867.member, (_e8867.member + _e10240), _e8854));
let _e10268 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e10241), _e8854));
let _e10269 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e10242), _e8854));
let _e10274 = (((_e10267 * _e10264) + (_e10268 * _e10265)) + (_e10269 * _e10266));
let _e10279 = (((_e10267 * _e482) + (_e10268 * _e495)) + (_e10269 * _e508));
let _e10284 = (((_e10264 * _e482) + (_e10265 * _e495)) + (_e10266 * _e508));
let _e10287 = ((_e10265 * _e508) - (_e10266 * _e495));
let _e10290 = ((_e10266 * _e482) - (_e10264 * _e508));
let _e10293 = ((_e10264 * _e495) - (_e10265 * _e482));
let _e10298 = (((_e10287 * _e10287) + (_e10290 * _e10290)) + (_e10293 * _e10293));
let _e10301 = (1f / select(1e-9f, _e10298, (_e10298 > 1e-9f)));
let _e10304 = ((_e10274 - (_e10284 * _e10279)) * _e10301);
let _e10307 = (((_e10284 * _e10274) - _e10279) * _e10301);
let _e10313 = select(0f, _e10304, (((_e10307 >= 0f) && (_e10307 < _e560)) && (_e10304 > 0f)));
let _e10315 = (_e10179 << bitcast<u32>(_e9805));
if _e10027 {
phi_24067_ = (_e9821.member - 1i);
} else {
phi_24067_ = _e10026;
}
let _e10330 = phi_24067_;
if _e10182 {
phi_24078_ = (_e9821.member_1 - 1i);
} else {
phi_24078_ = _e10181;
}
let _e10333 = phi_24078_;
let _e10337 = (((f32(_e10330) + 0.5f) * _e9826) - 0.5f);
let _e10341 = (((f32(_e10333) + 0.5f) * _e9826) - 0.5f);
if _e326 {
phi_24106_ = type_23(_e10333, _e10330);
} else {
phi_24106_ = type_23(_e10330, _e10333);
}
let _e10347 = phi_24106_;
if _e9897 {
phi_24157_ = 0u;
} else {
if (_e6540 == 1u) {
phi_24156_ = 0u;
} else {
if (_e6540 == 2u) {
phi_24155_ = _e9218;
} else {
phi_24155_ = select(_e9224, _e9221, (_e6540 == 3u));
}
let _e10355 = phi_24155_;
phi_24156_ = _e10355;
}
let _e10357 = phi_24156_;
phi_24157_ = _e10357;
}
let _e10359 = phi_24157_;
local_8 = (((bitcast<i32>(_e10359) + _e10347.member_1) * _e9215) + _e10347.member);
let _e10364 = local_8;
let _e10366 = select(_e9241, _e10364, (_e10364 < _e9241));
let _e10371 = global_5.member[bitcast<u32>(select(0i, _e10366, (_e10366 > 0i)))];
let _e10376 = (((((select(_e10337, _e10341, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e10381 = ((1f - (((select(_e10341, _e10337, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e10388 = ((_e8833.member * _e10376) + (_e8841.member * _e10381));
let _e10389 = ((_e8833.member_1 * _e10376) + (_e8841.member_1 * _e10381));
let _e10390 = ((_e8833.member_2 * _e10376) + (_e8841.member_2 * _e10381));
let _e10394 = select((_e8856.member + _e10388), _e8856.member, _e8854);
let _e10395 = select((_e8856.member_1 + _e10389), _e8856.member_1, _e8854);
let _e10396 = select((_e8856.member_2 + _e10390), _e8856.member_2, _e8854);
let _e10407 = (((_e10394 * _e10394) + (_e10395 * _e10395)) + (_e10396 * _e10396));
let _e10411 = (1f / sqrt(select(0f, _e10407, (_e10407 > 0f))));
let _e10412 = (_e10394 * _e10411);
let _e10413 = (_e10395 * _e10411);
let _e10414 = (_e10396 * _e10411);
let _e10415 = (_e444 - select(_e8867.member, (_e8867.member + _e10388), _e8854));
let _e10416 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e10389), _e8854));
let _e10417 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e10390), _e8854));
let _e10422 = (((_e10415 * _e10412) + (_e10416 * _e10413)) + (_e10417 * _e10414));
let _e10427 = (((_e10415 * _e482) + (_e10416 * _e495)) + (_e10417 * _e508));
let _e10432 = (((_e10412 * _e482) + (_e10413 * _e495)) + (_e10414 * _e508));
let _e10435 = ((_e10413 * _e508) - (_e10414 * _e495));
let _e10438 = ((_e10414 * _e482) - (_e10412 * _e508));
let _e10441 = ((_e10412 * _e495) - (_e10413 * _e482));
let _e10446 = (((_e10435 * _e10435) + (_e10438 * _e10438)) + (_e10441 * _e10441));
let _e10449 = (1f / select(1e-9f, _e10446, (_e10446 > 1e-9f)));
let _e10452 = ((_e10422 - (_e10432 * _e10427)) * _e10449);
let _e10455 = (((_e10432 * _e10422) - _e10427) * _e10449);
let _e10461 = select(0f, _e10452, (((_e10455 >= 0f) && (_e10455 < _e560)) && (_e10452 > 0f)));
let _e10463 = (_e10330 << bitcast<u32>(_e9805));
let _e10475 = select(((((_e9804 - select(0f, (_e9866 * _e9867), (((select(select(_e635, _e796, (_e10011 >= _e561)), _e716, (_e10011 < _e171)) == _e6540) && (_e10009 > 0f)) && (_e10009 < _e9919)))) - select(0f, (_e9863 * _e9867), (((select(select(_e635, _e796, (_e10163 >= _e561)), _e716, (_e10163 < _e171)) == _e6540) && (_e10161 > 0f)) && (_e10161 < _e10071)))) - select(0f, (_e9866 * _e9865), (((select(select(_e635, _e796, (_e10315 >= _e561)), _e716, (_e10315 < _e171)) == _e6540) && (_e10313 > 0f)) && (_e10313 < _e10223)))) - select(0f, (_e9863 * _e9865), (((select(select(_e635, _e796, (_e10463 >= _e561)), _e716, (_e10463 < _e171)) == _e6540) && (_e10461 > 0f)) && (_e10461 < _e10371)))), _e9804, _e9897);
let _e10476 = (_e6544 & 31u);
let _e10478 = (1u << bitcast<u32>(_e10476));
let _e10487 = bitcast<i32>((((_e799 + _e10478) - 1u) >> bitcast<u32>(_e10476)));
let _e10488 = bitcast<i32>((((_e802 + _e10478) - 1u) >> bitcast<u32>(_e10476)));
if _e326 {
phi_24592_ = type_23(_e10488, _e10487);
} else {
phi_24592_ = type_23(_e10487, _e10488);
}
let _e10492 = phi_24592_;
let _e10497 = f32((1i << bitcast<u32>(_e10476)));
let _e10498 = (1f / _e10497);
let _e10500 = ((_e8643 * _e10498) - 0.5f);
let _e10502 = ((_e8737 * _e10498) - 0.5f);
let _e10504 = select(-1f, _e10500, (_e10500 > -1f));
let _e10506 = select(1e6f, _e10504, (_e10504 < 1e6f));
let _e10513 = select(0i, select(select(i32(_e10506), i32(-2147483648), (_e10506 < -2147483600f)), 2147483647i, (_e10506 > 2147483500f)), (_e10506 == _e10506));
let _e10517 = (_e10513 - select(0i, 1i, (_e10506 < f32(_e10513))));
let _e10519 = select(-1f, _e10502, (_e10502 > -1f));
let _e10521 = select(1e6f, _e10519, (_e10519 < 1e6f));
let _e10528 = select(0i, select(select(i32(_e10521), i32(-2147483648), (_e10521 < -2147483600f)), 2147483647i, (_e10521 > 2147483500f)), (_e10521 == _e10521));
let _e10532 = (_e10528 - select(0i, 1i, (_e10521 < f32(_e10528))));
let _e10534 = (_e10500 - f32(_e10517));
let _e10536 = (_e10502 - f32(_e10532));
let _e10537 = (1f - _e10534);
let _e10538 = (1f - _e10536);
let _e10541 = select(_e10517, 0i, (_e10517 < 0i));
let _e10542 = (_e10541 >= _e10492.member);
if _e10542 {
phi_24670_ = (_e10492.member - 1i);
} else {
phi_24670_ = _e10541;
}
let _e10545 = phi_24670_;
let _e10547 = select(_e10532, 0i, (_e10532 < 0i));
let _e10548 = (_e10547 >= _e10492.member_1);
if _e10548 {
phi_24681_ = (_e10492.member_1 - 1i);
} else {
phi_24681_ = _e10547;
}
let _e10551 = phi_24681_;
let _e10555 = (((f32(_e10545) + 0.5f) * _e10497) - 0.5f);
let _e10559 = (((f32(_e10551) + 0.5f) * _e10497) - 0.5f);
if _e326 {
phi_24709_ = type_23(_e10551, _e10545);
} else {
phi_24709_ = type_23(_e10545, _e10551);
}
let _e10565 = phi_24709_;
let _e10568 = (_e6544 == 0u);
if _e10568 {
phi_24760_ = 0u;
} else {
if (_e6544 == 1u) {
phi_24759_ = 0u;
} else {
if (_e6544 == 2u) {
phi_24758_ = _e9218;
} else {
phi_24758_ = select(_e9224, _e9221, (_e6544 == 3u));
}
let _e10574 = phi_24758_;
phi_24759_ = _e10574;
}
let _e10576 = phi_24759_;
phi_24760_ = _e10576;
}
let _e10578 = phi_24760_;
local_6 = (((bitcast<i32>(_e10578) + _e10565.member_1) * _e9215) + _e10565.member);
let _e10583 = local_6;
let _e10585 = select(_e9241, _e10583, (_e10583 < _e9241));
let _e10590 = global_5.member[bitcast<u32>(select(0i, _e10585, (_e10585 > 0i)))];
let _e10595 = (((((select(_e10555, _e10559, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e10600 = ((1f - (((select(_e10559, _e10555, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e10607 = ((_e8833.member * _e10595) + (_e8841.member * _e10600));
let _e10608 = ((_e8833.member_1 * _e10595) + (_e8841.member_1 * _e10600));
let _e10609 = ((_e8833.member_2 * _e10595) + (_e8841.member_2 * _e10600));
let _e10613 = select((_e8856.member + _e10607), _e8856.member, _e8854);
let _e10614 = select((_e8856.member_1 + _e10608), _e8856.member_1, _e8854);
let _e10615 = select((_e8856.member_2 + _e10609), _e8856.member_2, _e8854);
let _e10626 = (((_e10613 * _e10613) + (_e10614 * _e10614)) + (_e10615 * _e10615));
let _e10630 = (1f / sqrt(select(0f, _e10626, (_e10626 > 0f))));
let _e10631 = (_e10613 * _e10630);
let _e10632 = (_e10614 * _e10630);
let _e10633 = (_e10615 * _e10630);
let _e10634 = (_e444 - select(_e8867.member, (_e8867.member + _e10607), _e8854));
let _e10635 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e10608), _e8854));
let _e10636 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e10609), _e8854));
let _e10641 = (((_e10634 * _e10631) + (_e10635 * _e10632)) + (_e10636 * _e10633));
let _e10646 = (((_e10634 * _e482) + (_e10635 * _e495)) + (_e10636 * _e508));
let _e10651 = (((_e10631 * _e482) + (_e10632 * _e495)) + (_e10633 * _e508));
let _e10654 = ((_e10632 * _e508) - (_e10633 * _e495));
let _e10657 = ((_e10633 * _e482) - (_e10631 * _e508));
let _e10660 = ((_e10631 * _e495) - (_e10632 * _e482));
let _e10665 = (((_e10654 * _e10654) + (_e10657 * _e10657)) + (_e10660 * _e10660));
let _e10668 = (1f / select(1e-9f, _e10665, (_e10665 > 1e-9f)));
let _e10671 = ((_e10641 - (_e10651 * _e10646)) * _e10668);
let _e10674 = (((_e10651 * _e10641) - _e10646) * _e10668);
let _e10680 = select(0f, _e10671, (((_e10674 >= 0f) && (_e10674 < _e560)) && (_e10671 > 0f)));
let _e10682 = (_e10545 << bitcast<u32>(_e10476));
let _e10694 = (_e10517 + 1i);
let _e10697 = select(_e10694, 0i, (_e10694 < 0i));
let _e10698 = (_e10697 >= _e10492.member);
if _e10698 {
phi_25177_ = (_e10492.member - 1i);
} else {
phi_25177_ = _e10697;
}
let _e10701 = phi_25177_;
if _e10548 {
phi_25188_ = (_e10492.member_1 - 1i);
} else {
phi_25188_ = _e10547;
}
let _e10704 = phi_25188_;
let _e10708 = (((f32(_e10701) + 0.5f) * _e10497) - 0.5f);
let _e10712 = (((f32(_e10704) + 0.5f) * _e10497) - 0.5f);
if _e326 {
phi_25216_ = type_23(_e10704, _e10701);
} else {
phi_25216_ = type_23(_e10701, _e10704);
}
let _e10718 = phi_25216_;
if _e10568 {
phi_25267_ = 0u;
} else {
if (_e6544 == 1u) {
phi_25266_ = 0u;
} else {
if (_e6544 == 2u) {
phi_25265_ = _e9218;
} else {
phi_25265_ = select(_e9224, _e9221, (_e6544 == 3u));
}
let _e10726 = phi_25265_;
phi_25266_ = _e10726;
}
let _e10728 = phi_25266_;
phi_25267_ = _e10728;
}
let _e10730 = phi_25267_;
local_4 = (((bitcast<i32>(_e10730) + _e10718.member_1) * _e9215) + _e10718.member);
let _e10735 = local_4;
let _e10737 = select(_e9241, _e10735, (_e10735 < _e9241));
let _e10742 = global_5.member[bitcast<u32>(select(0i, _e10737, (_e10737 > 0i)))];
let _e10747 = (((((select(_e10708, _e10712, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e10752 = ((1f - (((select(_e10712, _e10708, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e10759 = ((_e8833.member * _e10747) + (_e8841.member * _e10752));
let _e10760 = ((_e8833.member_1 * _e10747) + (_e8841.member_1 * _e10752));
let _e10761 = ((_e8833.member_2 * _e10747) + (_e8841.member_2 * _e10752));
let _e10765 = select((_e8856.member + _e10759), _e8856.member, _e8854);
let _e10766 = select((_e8856.member_1 + _e10760), _e8856.member_1, _e8854);
let _e10767 = select((_e8856.member_2 + _e10761), _e8856.member_2, _e8854);
let _e10778 = (((_e10765 * _e10765) + (_e10766 * _e10766)) + (_e10767 * _e10767));
let _e10782 = (1f / sqrt(select(0f, _e10778, (_e10778 > 0f))));
let _e10783 = (_e10765 * _e10782);
let _e10784 = (_e10766 * _e10782);
let _e10785 = (_e10767 * _e10782);
let _e10786 = (_e444 - select(_e8867.member, (_e8867.member + _e10759), _e8854));
let _e10787 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e10760), _e8854));
let _e10788 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e10761), _e8854));
let _e10793 = (((_e10786 * _e10783) + (_e10787 * _e10784)) + (_e10788 * _e10785));
let _e10798 = (((_e10786 * _e482) + (_e10787 * _e495)) + (_e10788 * _e508));
let _e10803 = (((_e10783 * _e482) + (_e10784 * _e495)) + (_e10785 * _e508));
let _e10806 = ((_e10784 * _e508) - (_e10785 * _e495));
let _e10809 = ((_e10785 * _e482) - (_e10783 * _e508));
let _e10812 = ((_e10783 * _e495) - (_e10784 * _e482));
let _e10817 = (((_e10806 * _e10806) + (_e10809 * _e10809)) + (_e10812 * _e10812));
let _e10820 = (1f / select(1e-9f, _e10817, (_e10817 > 1e-9f)));
let _e10823 = ((_e10793 - (_e10803 * _e10798)) * _e10820);
let _e10826 = (((_e10803 * _e10793) - _e10798) * _e10820);
let _e10832 = select(0f, _e10823, (((_e10826 >= 0f) && (_e10826 < _e560)) && (_e10823 > 0f)));
let _e10834 = (_e10701 << bitcast<u32>(_e10476));
let _e10846 = (_e10532 + 1i);
if _e10542 {
phi_25684_ = (_e10492.member - 1i);
} else {
phi_25684_ = _e10541;
}
let _e10850 = phi_25684_;
let _e10852 = select(_e10846, 0i, (_e10846 < 0i));
let _e10853 = (_e10852 >= _e10492.member_1);
if _e10853 {
phi_25695_ = (_e10492.member_1 - 1i);
} else {
phi_25695_ = _e10852;
}
let _e10856 = phi_25695_;
let _e10860 = (((f32(_e10850) + 0.5f) * _e10497) - 0.5f);
let _e10864 = (((f32(_e10856) + 0.5f) * _e10497) - 0.5f);
if _e326 {
phi_25723_ = type_23(_e10856, _e10850);
} else {
phi_25723_ = type_23(_e10850, _e10856);
}
let _e10870 = phi_25723_;
if _e10568 {
phi_25774_ = 0u;
} else {
if (_e6544 == 1u) {
phi_25773_ = 0u;
} else {
if (_e6544 == 2u) {
phi_25772_ = _e9218;
} else {
phi_25772_ = select(_e9224, _e9221, (_e6544 == 3u));
}
let _e10878 = phi_25772_;
phi_25773_ = _e10878;
}
let _e10880 = phi_25773_;
phi_25774_ = _e10880;
}
let _e10882 = phi_25774_;
local_2 = (((bitcast<i32>(_e10882) + _e10870.member_1) * _e9215) + _e10870.member);
let _e10887 = local_2;
let _e10889 = select(_e9241, _e10887, (_e10887 < _e9241));
let _e10894 = global_5.member[bitcast<u32>(select(0i, _e10889, (_e10889 > 0i)))];
let _e10899 = (((((select(_e10860, _e10864, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e10904 = ((1f - (((select(_e10864, _e10860, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e10911 = ((_e8833.member * _e10899) + (_e8841.member * _e10904));
let _e10912 = ((_e8833.member_1 * _e10899) + (_e8841.member_1 * _e10904));
let _e10913 = ((_e8833.member_2 * _e10899) + (_e8841.member_2 * _e10904));
let _e10917 = select((_e8856.member + _e10911), _e8856.member, _e8854);
let _e10918 = select((_e8856.member_1 + _e10912), _e8856.member_1, _e8854);
let _e10919 = select((_e8856.member_2 + _e10913), _e8856.member_2, _e8854);
let _e10930 = (((_e10917 * _e10917) + (_e10918 * _e10918)) + (_e10919 * _e10919));
let _e10934 = (1f / sqrt(select(0f, _e10930, (_e10930 > 0f))));
let _e10935 = (_e10917 * _e10934);
let _e10936 = (_e10918 * _e10934);
let _e10937 = (_e10919 * _e10934);
let _e10938 = (_e444 - select(_e8867.member, (_e8867.member + _e10911), _e8854));
let _e10939 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e10912), _e8854));
let _e10940 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e10913), _e8854));
let _e10945 = (((_e10938 * _e10935) + (_e10939 * _e10936)) + (_e10940 * _e10937));
let _e10950 = (((_e10938 * _e482) + (_e10939 * _e495)) + (_e10940 * _e508));
let _e10955 = (((_e10935 * _e482) + (_e10936 * _e495)) + (_e10937 * _e508));
let _e10958 = ((_e10936 * _e508) - (_e10937 * _e495));
let _e10961 = ((_e10937 * _e482) - (_e10935 * _e508));
let _e10964 = ((_e10935 * _e495) - (_e10936 * _e482));
let _e10969 = (((_e10958 * _e10958) + (_e10961 * _e10961)) + (_e10964 * _e10964));
let _e10972 = (1f / select(1e-9f, _e10969, (_e10969 > 1e-9f)));
let _e10975 = ((_e10945 - (_e10955 * _e10950)) * _e10972);
let _e10978 = (((_e10955 * _e10945) - _e10950) * _e10972);
let _e10984 = select(0f, _e10975, (((_e10978 >= 0f) && (_e10978 < _e560)) && (_e10975 > 0f)));
let _e10986 = (_e10850 << bitcast<u32>(_e10476));
if _e10698 {
phi_26191_ = (_e10492.member - 1i);
} else {
phi_26191_ = _e10697;
}
let _e11001 = phi_26191_;
if _e10853 {
phi_26202_ = (_e10492.member_1 - 1i);
} else {
phi_26202_ = _e10852;
}
let _e11004 = phi_26202_;
let _e11008 = (((f32(_e11001) + 0.5f) * _e10497) - 0.5f);
let _e11012 = (((f32(_e11004) + 0.5f) * _e10497) - 0.5f);
if _e326 {
phi_26230_ = type_23(_e11004, _e11001);
} else {
phi_26230_ = type_23(_e11001, _e11004);
}
let _e11018 = phi_26230_;
if _e10568 {
phi_26281_ = 0u;
} else {
if (_e6544 == 1u) {
phi_26280_ = 0u;
} else {
if (_e6544 == 2u) {
phi_26279_ = _e9218;
} else {
phi_26279_ = select(_e9224, _e9221, (_e6544 == 3u));
}
let _e11026 = phi_26279_;
phi_26280_ = _e11026;
}
let _e11028 = phi_26280_;
phi_26281_ = _e11028;
}
let _e11030 = phi_26281_;
local = (((bitcast<i32>(_e11030) + _e11018.member_1) * _e9215) + _e11018.member);
let _e11035 = local;
let _e11037 = select(_e9241, _e11035, (_e11035 < _e9241));
let _e11042 = global_5.member[bitcast<u32>(select(0i, _e11037, (_e11037 > 0i)))];
let _e11047 = (((((select(_e11008, _e11012, _e326) + 0.5f) / _e8814) * 2f) - 1f) * _e8822);
let _e11052 = ((1f - (((select(_e11012, _e11008, _e326) + 0.5f) / _e8815) * 2f)) * _e8830);
let _e11059 = ((_e8833.member * _e11047) + (_e8841.member * _e11052));
let _e11060 = ((_e8833.member_1 * _e11047) + (_e8841.member_1 * _e11052));
let _e11061 = ((_e8833.member_2 * _e11047) + (_e8841.member_2 * _e11052));
let _e11065 = select((_e8856.member + _e11059), _e8856.member, _e8854);
let _e11066 = select((_e8856.member_1 + _e11060), _e8856.member_1, _e8854);
let _e11067 = select((_e8856.member_2 + _e11061), _e8856.member_2, _e8854);
let _e11078 = (((_e11065 * _e11065) + (_e11066 * _e11066)) + (_e11067 * _e11067));
let _e11082 = (1f / sqrt(select(0f, _e11078, (_e11078 > 0f))));
let _e11083 = (_e11065 * _e11082);
let _e11084 = (_e11066 * _e11082);
let _e11085 = (_e11067 * _e11082);
let _e11086 = (_e444 - select(_e8867.member, (_e8867.member + _e11059), _e8854));
let _e11087 = (_e456 - select(_e8867.member_1, (_e8867.member_1 + _e11060), _e8854));
let _e11088 = (_e469 - select(_e8867.member_2, (_e8867.member_2 + _e11061), _e8854));
let _e11093 = (((_e11086 * _e11083) + (_e11087 * _e11084)) + (_e11088 * _e11085));
let _e11098 = (((_e11086 * _e482) + (_e11087 * _e495)) + (_e11088 * _e508));
let _e11103 = (((_e11083 * _e482) + (_e11084 * _e495)) + (_e11085 * _e508));
let _e11106 = ((_e11084 * _e508) - (_e11085 * _e495));
let _e11109 = ((_e11085 * _e482) - (_e11083 * _e508));
let _e11112 = ((_e11083 * _e495) - (_e11084 * _e482));
let _e11117 = (((_e11106 * _e11106) + (_e11109 * _e11109)) + (_e11112 * _e11112));
let _e11120 = (1f / select(1e-9f, _e11117, (_e11117 > 1e-9f)));
let _e11123 = ((_e11093 - (_e11103 * _e11098)) * _e11120);
let _e11126 = (((_e11103 * _e11093) - _e11098) * _e11120);
let _e11132 = select(0f, _e11123, (((_e11126 >= 0f) && (_e11126 < _e560)) && (_e11123 > 0f)));
let _e11134 = (_e11001 << bitcast<u32>(_e10476));
let _e11146 = select(((((_e10475 - select(0f, (_e10537 * _e10538), (((select(select(_e635, _e796, (_e10682 >= _e561)), _e716, (_e10682 < _e171)) == _e6544) && (_e10680 > 0f)) && (_e10680 < _e10590)))) - select(0f, (_e10534 * _e10538), (((select(select(_e635, _e796, (_e10834 >= _e561)), _e716, (_e10834 < _e171)) == _e6544) && (_e10832 > 0f)) && (_e10832 < _e10742)))) - select(0f, (_e10537 * _e10536), (((select(select(_e635, _e796, (_e10986 >= _e561)), _e716, (_e10986 < _e171)) == _e6544) && (_e10984 > 0f)) && (_e10984 < _e10894)))) - select(0f, (_e10534 * _e10536), (((select(select(_e635, _e796, (_e11134 >= _e561)), _e716, (_e11134 < _e171)) == _e6544) && (_e11132 > 0f)) && (_e11132 < _e11042)))), _e10475, _e10568);
if _e326 {
phi_26707_ = type_23(_e8734, _e8641);
} else {
phi_26707_ = type_23(_e8641, _e8734);
}
let _e11161 = phi_26707_;
let _e11164 = (_e8735 && (((_e9132 > 0f) && (_e9132 < _e8803)) && (bitcast<f32>((bitcast<u32>(_e11146) & 2147483647u)) > 1e-6f)));
let _e11167 = global_1.member.member_18.member;
let _e11168 = (((select(_e8760, (1f - _e8760), (_e8745 >= 0f)) - select(_e8779, (1f - _e8779), (_e8764 >= 0f))) * (1f / _e8742)) * _e11167);
let _e11172 = select(0f, (((((_e521 * _e9119.member) * ((1f + (_e8972 * (1f + (_e8972 * (0.5f + (_e8972 * (0.16666667f + (_e8972 * (0.041666668f + (_e8972 * (0.008333334f + (_e8972 * (0.001388889f + (_e8972 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8967 + 127i)) << bitcast<u32>(23i))))) * _e9116) * _e11146) * _e11168), _e11164);
let _e11173 = select(0f, (((((_e534 * _e9119.member_1) * ((1f + (_e9020 * (1f + (_e9020 * (0.5f + (_e9020 * (0.16666667f + (_e9020 * (0.041666668f + (_e9020 * (0.008333334f + (_e9020 * (0.001388889f + (_e9020 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9015 + 127i)) << bitcast<u32>(23i))))) * _e9116) * _e11146) * _e11168), _e11164);
let _e11174 = select(0f, (((((_e547 * _e9119.member_2) * ((1f + (_e9068 * (1f + (_e9068 * (0.5f + (_e9068 * (0.16666667f + (_e9068 * (0.041666668f + (_e9068 * (0.008333334f + (_e9068 * (0.001388889f + (_e9068 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9063 + 127i)) << bitcast<u32>(23i))))) * _e9116) * _e11146) * _e11168), _e11164);
let _e11178 = (bitcast<f32>((bitcast<u32>(_e11172) & 2147483647u)) >= 1073741800f);
let _e11179 = (1f / 1048576f);
let _e11182 = ((_e11172 * select(1f, _e11179, _e11178)) + 0.5f);
let _e11184 = select(-1073741800f, _e11182, (_e11182 > -1073741800f));
let _e11186 = select(1073741800f, _e11184, (_e11184 < 1073741800f));
let _e11193 = select(0i, select(select(i32(_e11186), i32(-2147483648), (_e11186 < -2147483600f)), 2147483647i, (_e11186 > 2147483500f)), (_e11186 == _e11186));
let _e11197 = (_e11193 - select(0i, 1i, (_e11186 < f32(_e11193))));
let _e11198 = select(0i, 20i, _e11178);
let _e11202 = (bitcast<u32>(_e11197) << bitcast<u32>((_e11198 & 31i)));
let _e11209 = bitcast<u32>(((_e11197 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11198) & 31i))));
let _e11213 = (bitcast<f32>((bitcast<u32>(_e11173) & 2147483647u)) >= 1073741800f);
let _e11216 = ((_e11173 * select(1f, _e11179, _e11213)) + 0.5f);
let _e11218 = select(-1073741800f, _e11216, (_e11216 > -1073741800f));
let _e11220 = select(1073741800f, _e11218, (_e11218 < 1073741800f));
let _e11227 = select(0i, select(select(i32(_e11220), i32(-2147483648), (_e11220 < -2147483600f)), 2147483647i, (_e11220 > 2147483500f)), (_e11220 == _e11220));
let _e11231 = (_e11227 - select(0i, 1i, (_e11220 < f32(_e11227))));
let _e11232 = select(0i, 20i, _e11213);
let _e11236 = (bitcast<u32>(_e11231) << bitcast<u32>((_e11232 & 31i)));
let _e11243 = bitcast<u32>(((_e11231 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11232) & 31i))));
let _e11247 = (bitcast<f32>((bitcast<u32>(_e11174) & 2147483647u)) >= 1073741800f);
let _e11250 = ((_e11174 * select(1f, _e11179, _e11247)) + 0.5f);
let _e11252 = select(-1073741800f, _e11250, (_e11250 > -1073741800f));
let _e11254 = select(1073741800f, _e11252, (_e11252 < 1073741800f));
let _e11261 = select(0i, select(select(i32(_e11254), i32(-2147483648), (_e11254 < -2147483600f)), 2147483647i, (_e11254 > 2147483500f)), (_e11254 == _e11254));
let _e11265 = (_e11261 - select(0i, 1i, (_e11254 < f32(_e11261))));
let _e11266 = select(0i, 20i, _e11247);
let _e11270 = (bitcast<u32>(_e11265) << bitcast<u32>((_e11266 & 31i)));
let _e11277 = bitcast<u32>(((_e11265 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11266) & 31i))));
let _e11282 = bitcast<i32>(bitcast<u32>((((_e11161.member_1 * _e803) + _e11161.member) * 6i)));
if ((_e11202 | _e11209) == 0u) {
} else {
let _e11285 = bitcast<u32>(_e11282);
if (_e11285 < _e143) {
let _e11289 = atomicAdd((&global_6.member[_e11285]), _e11202);
phi_26940_ = _e11289;
} else {
phi_26940_ = 0u;
}
let _e11291 = phi_26940_;
let _e11295 = (_e11209 + select(0u, 1u, ((_e11291 + _e11202) < _e11202)));
if (_e11295 == 0u) {
} else {
let _e11297 = (_e11285 + 1u);
if (_e11297 < _e143) {
let _e11301 = atomicAdd((&global_6.member[_e11297]), _e11295);
}
}
}
if ((_e11236 | _e11243) == 0u) {
} else {
let _e11305 = bitcast<u32>((_e11282 + 2i));
if (_e11305 < _e143) {
let _e11309 = atomicAdd((&global_6.member[_e11305]), _e11236);
phi_26970_ = _e11309;
} else {
phi_26970_ = 0u;
}
let _e11311 = phi_26970_;
let _e11315 = (_e11243 + select(0u, 1u, ((_e11311 + _e11236) < _e11236)));
if (_e11315 == 0u) {
} else {
let _e11317 = (_e11305 + 1u);
if (_e11317 < _e143) {
let _e11321 = atomicAdd((&global_6.member[_e11317]), _e11315);
}
}
}
if ((_e11270 | _e11277) == 0u) {
} else {
let _e11325 = bitcast<u32>((_e11282 + 4i));
if (_e11325 < _e143) {
let _e11329 = atomicAdd((&global_6.member[_e11325]), _e11270);
phi_27000_ = _e11329;
} else {
phi_27000_ = 0u;
}
let _e11331 = phi_27000_;
let _e11335 = (_e11277 + select(0u, 1u, ((_e11331 + _e11270) < _e11270)));
if (_e11335 == 0u) {
} else {
let _e11337 = (_e11325 + 1u);
if (_e11337 < _e143) {
let _e11341 = atomicAdd((&global_6.member[_e11337]), _e11335);
}
}
}
phi_19696_ = (_e8732 + 1i);
} else {
phi_19696_ = i32();
}
let _e11344 = phi_19696_;
continue;
continuing {
phi_19695_ = _e11344;
break if !(_e8735);
}
}
phi_19542_ = (_e8638 + 1i);
} else {
phi_19542_ = i32();
}
let _e11348 = phi_19542_;
continue;
continuing {
phi_19541_ = _e11348;
break if !(_e8639);
}
}
}
}
}
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
